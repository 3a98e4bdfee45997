#!/bin/sh
# The cost of each term: a Markdown table of scenes (counted_scenes.hpp) with the terms compiled in, the instructions
# per particle and step, and the memory held per particle.
# Usage: terms_table.sh PROGRAM [SCENE...]      the others are compared with the first scene
#   instructions   counted by callgrind on one thread; the difference of a longer and a shorter run, in which the parts
#                  before the first step and after the last one cancel
#   memory         the arrays that the run reports, and the total held at its last sample, counted in operator new
# Exit status: 0, or 2 where valgrind is missing or a scene cannot be run.
set -eu

program=$1
shift
if [ $# = 0 ]; then
  set -- recommended still no_gauge no_viscosity no_diffusion antuono linear_state wendland_c2 \
    predictor_corrector verlet ghost_walls dynamic_walls baffle roll dam pressure_gauge \
    still_water energy_budget snapshots saved_states li2010 delta_sph zhao2021_moving+roll zhao2021_fixed+roll
fi
if ! command -v valgrind >/dev/null; then
  echo "the table needs valgrind" >&2
  exit 2
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

run() {  # SCENE DURATION; writes what the run prints, and its instructions, to $work/facts
  OMP_NUM_THREADS=1 valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" "$1" "$2" \
    >"$work/facts" 2>"$work/log" || { cat "$work/facts" "$work/log" >&2; exit 2; }
  sed -n 's/.*Collected : \([0-9]*\).*/instructions|\1/p' "$work/log" >>"$work/facts"
}

for scene; do
  echo "counting $scene" >&2
  echo "scene|$scene"
  run "$scene" 0.02
  sed -n 's/^steps|/steps before|/p; s/^instructions|/instructions before|/p' "$work/facts"
  run "$scene" 0.05
  cat "$work/facts"
done >"$work/all"

awk -F'|' '
# names[list, 1..count[list]] keeps the order of entry.
function enter(list, name) { if (!((list, name) in has)) { has[list, name] = 1; names[list, ++count[list]] = name } }
# Returns the names in list a that are not in list b, joined by "; ", or by ", " after an equal prefix up to a colon.
function beyond(a, b,    i, name, kind, last, joined) {
  for (i = 1; i <= count[a]; ++i) {
    name = names[a, i]
    if ((b, name) in has) continue
    kind = index(name, ":") ? substr(name, 1, index(name, ":")) : ""
    if (kind != "" && kind == last) joined = joined "," substr(name, length(kind) + 1)
    else joined = joined (joined == "" ? "" : "; ") name
    last = kind
  }
  return joined
}
function difference(kind,    less, more) {
  less = beyond(base kind, scene kind)
  more = beyond(scene kind, base kind)
  return (less == "" ? "" : "without " less) (less != "" && more != "" ? "<br>" : "") (more == "" ? "" : "with " more)
}
function per_particle(purpose) { return bytes[scene, purpose] / value[scene, "particles"] }
function row(    steps, particles, instructions, change) {
  particles = value[scene, "particles"]
  steps = value[scene, "steps"] - value[scene, "steps before"]
  instructions = (value[scene, "instructions"] - value[scene, "instructions before"]) / (steps * particles)
  if (scene == base) base_instructions = instructions
  change = scene == base ? "" : sprintf("%+.1f", instructions - base_instructions)
  printf "| `%s` | %s | %.1f | %s | %s | %.0f | %.0f | %.0f | %.0f | %.0f | %.0f |\n", scene, difference(" terms"),
    instructions, change, difference(" arrays"), per_particle("state"), per_particle("rates"),
    per_particle("neighbours"), per_particle("record"), per_particle("others"), value[scene, "counted"] / particles
}
$1 == "scene" { scene = $2; order[++scenes] = scene; if (base == "") base = scene; next }
$1 == "term" { enter(scene " terms", $2); next }
$1 == "held" {
  enter(scene " arrays", $2 ": " $3)
  bytes[scene, $2 ~ /^(state|rates|neighbours|record)$/ ? $2 : "others"] += $4
  next
}
{ value[scene, $1] = $2 }
END {
  printf "Terms of `%s`: %s.\n\n", base, beyond(base " terms", "")
  printf "Its arrays: %s.\n\n", beyond(base " arrays", "")
  printf "Instructions per particle and step (%s, one thread); bytes per particle.\n\n", value[base, "instruction set"]
  print "| scene | terms | instructions | difference | arrays | state | rates | neighbours | record | others | counted |"
  print "|---|---|---|---|---|---|---|---|---|---|---|"
  for (i = 1; i <= scenes; ++i) { scene = order[i]; row() }
}' "$work/all"
