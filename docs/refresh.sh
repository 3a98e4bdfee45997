#!/bin/sh
# Makes anew what the documents take from the product: the tutorial's picture and the gallery's figures.
# It takes about half an hour on two cores.
# Usage: docs/refresh.sh
set -eu
cd "$(dirname -- "$0")/.."
./slosh campaign docs/tutorial/campaign.toml -o build/own_tank
rm -f docs/own_tank.png # no file that Slosh has left there, which it would not replace
./slosh show docs/tutorial/own_tank.toml -o docs/own_tank.png
./slosh campaign small_amplitude
for figure in docs/gallery/*.svg; do
  cp "build/campaigns/small_amplitude/report/figures/$(basename "$figure")" docs/gallery/
done
