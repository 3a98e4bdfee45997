#!/bin/sh
# Makes anew what the documents take from the product: the tutorial's verdicts and picture, the tables of the small surge,
# and the sample of the verdicts.
# Usage: docs/refresh.sh
set -eu
cd "$(dirname -- "$0")/.."
./slosh campaign docs/tutorial/campaign.toml -o build/own_tank | tee build/own_tank.txt
python3 docs/printed_lines.py docs/tutorial.md < build/own_tank.txt
rm -f docs/own_tank.png # no file that Slosh has left there, which it would not replace
./slosh show docs/tutorial/own_tank.toml -o docs/own_tank.png
./slosh campaign small_amplitude # after a gate in its directory only this makes its results.json
python3 docs/small_surge_tables.py build/campaigns/small_amplitude/report/results.json
./slosh gate small_amplitude --quick -o build/sample
mkdir -p docs/sample
cp build/sample/gate/gate.md docs/sample/gate.md
sed -i -E "s/(gate\.md\) \()[^)]*/\1$(date -u '+%-d %B %Y'), commit $(git rev-parse --short=8 HEAD)/" README.md
