#!/bin/sh
# Makes anew what the documents take from the product: the tutorial's picture.
# Usage: docs/refresh.sh
set -eu
cd "$(dirname -- "$0")/.."
./slosh campaign docs/tutorial/campaign.toml -o build/own_tank
rm -f docs/own_tank.png # no file that Slosh has left there, which it would not replace
./slosh show docs/tutorial/own_tank.toml -o docs/own_tank.png
