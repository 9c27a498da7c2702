#!/bin/sh
# Tunes planners with irace and writes tuned/NAME.toml: all of planners.json, or those that are named.
# usage: experiments/tuning/tune.sh [NAME…]
# FORMICARIUM is the program, target/release/formicarium unless it says otherwise. Maps and irace's logs go into WORK, target/tuning.
set -e
here=$(realpath "$(dirname "$0")")
FORMICARIUM=$(realpath "${FORMICARIUM:-$here/../../target/release/formicarium}")
WORK=$(realpath -m "${WORK:-$here/../../target/tuning}")
export FORMICARIUM WORK TUNED
cd "$here"
[ $# -gt 0 ] || set -- $(jq -r 'keys_unsorted[]' planners.json)
./parameters.sh "$@"
[ -e "$WORK/maps/terrain.txt" ] || ./maps.sh "$WORK/maps"
for name; do
    TUNED=$(jq -r --arg name "$name" '.[$name] | "--planner " + .planner + if .preset then " --preset " + .preset else "" end' planners.json)
    Rscript race.R "$name" "$(jq -r --arg name "$name" '.[$name].maps' planners.json)" > "$WORK/$name.log" 2>&1
    cat "tuned/$name.toml"
done
