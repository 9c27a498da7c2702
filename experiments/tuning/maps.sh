#!/bin/sh
# Makes the training maps, and for each group the list of its instances: FOLDER/GROUP.txt. Kinds of a group take turns in it.
# The maps of experiments/maps have seeds from 1, these from 1001: nothing is tuned on what it is judged by.
# usage: FORMICARIUM=… maps.sh FOLDER
set -e
maps=$(realpath "$(dirname "$0")/../maps")
mkdir -p "$1"
cd "$1"
rm -f ship.txt threshold.txt fireworks.txt fire.txt terrain.txt

# generate KIND SIZE SEED [OPTIONS]: prints the file that it made.
generate() {
    file="$PWD/$1-$2-$3.json"
    kind=$1 size=$2 seed=$3
    shift 3
    "$FORMICARIUM" generate "$kind" --size "$size" --seed "$seed" "$@" --as scenario --out "$file" >&2
    echo "$file"
}

for seed in $(seq 1001 1010); do
    generate blocks 20x20 "$seed" --density 0.2 >> ship.txt
    generate blocks 30x30 "$seed" --density 0.2 >> ship.txt
    # Odd seeds from the upper left corner, even ones from the lower right.
    ends=
    if [ $((seed % 2)) -eq 0 ]; then ends=" --from 19,19 --to 0,0"; fi
    echo "$(generate bars 20x20 "$seed" --density 0.3)$ends" >> threshold.txt
    echo "$(generate random 20x20 "$seed" --density 0.35)$ends" >> threshold.txt
    echo "$(generate hills 21x21 "$seed") --model slices --from 0,10 --to 20,8" >> terrain.txt
    echo "$(generate hills 31x31 "$seed") --model slices --from 0,15 --to 30,11" >> terrain.txt
done
for seed in $(seq 1001 1020); do
    generate bars 20x20 "$seed" --density 0.25 >> fireworks.txt
done
# The fires and their weights on new blocks; a map with a block where a fire or the start is, is left out.
seed=1001
while ! [ -e fire.txt ] || [ "$(wc -l < fire.txt)" -lt 20 ]; do
    blocks=$(generate blocks 20x20 "$seed" --density 0.2)
    if jq -e --slurpfile blocks "$blocks" '[.start, .goals[].at] | all(. as [$x, $y] | $blocks[0].map.rows[$y][$x:$x + 1] == ".")' \
        "$maps/fire-20x20.json" > free.json; then
        jq --slurpfile blocks "$blocks" --arg seed "$seed" '.map = $blocks[0].map | .name = "Blocks with four fires, seed " + $seed' \
            "$maps/fire-20x20.json" > "fires-$seed.json"
        echo "$PWD/fires-$seed.json" >> fire.txt
    fi
    seed=$((seed + 1))
done
rm free.json
