#!/bin/sh
# Runs presets and tuned values on all training maps, seeds 1 to 10, and writes the means of training.csv.
# usage: experiments/tuning/means.sh, after tune.sh, with the same FORMICARIUM and WORK
set -e
here=$(realpath "$(dirname "$0")")
FORMICARIUM=$(realpath "${FORMICARIUM:-$here/../../target/release/formicarium}")
WORK=$(realpath -m "${WORK:-$here/../../target/tuning}")
export FORMICARIUM TUNED
cd "$here"

# runs NAME SETTING [--set …]: one cost a line, and from it a row of the table.
runs() {
    row=$1,$2
    group=$(jq -r --arg name "$1" '.[$name].maps' planners.json)
    TUNED=$(jq -r --arg name "$1" '.[$name] | "--planner " + .planner + if .preset then " --preset " + .preset else "" end' planners.json)
    shift 2
    while read -r instance; do
        for seed in 1 2 3 4 5 6 7 8 9 10; do
            ./target-runner - - "$seed" "$instance" "$@" < /dev/null
        done
    done < "$WORK/maps/$group.txt" |
        awk -v row="$row" '$1 < 10000 { found++; sum += $1 } END { printf "%s,%d,%d,%.3f\n", row, NR, found, found ? sum / found : 0 }'
}

echo "name,setting,runs,found,mean" > training.csv
for name in $(jq -r 'keys_unsorted[]' planners.json); do
    runs "$name" preset >> training.csv
    # set = { a = 1, b = 2 } as --set a=1 --set b=2
    runs "$name" tuned $(sed -n 's/^set = { \(.*\) }$/\1/p' "tuned/$name.toml" | sed 's/ = /=/g; s/^/--set /; s/, / --set /g') >> training.csv
done
