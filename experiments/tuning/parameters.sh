#!/bin/sh
# Writes for irace what `formicarium catalog` knows of the planners of planners.json:
#   parameters/NAME.txt           what may vary, in the engine's ranges, or in narrower ones that planners.json gives. A range over more
#                                 than three decades is searched by its logarithm, from 0.001 to 1000.
#   parameters/NAME.default.txt   the values of the preset, with which the search begins.
# usage: FORMICARIUM=… parameters.sh NAME…
set -e
cd "$(dirname "$0")"
mkdir -p parameters
catalog=$("$FORMICARIUM" catalog --json)
for name; do
    printf %s "$catalog" | jq -r --arg name "$name" --slurpfile planners planners.json '
        $planners[0][$name] as $tuned
        | (.planners[] | select(.id == $tuned.planner) | .params) as $params
        | $tuned.keys[] as $key
        | ($params[] | select(.key == $key) | .kind) as $kind
        | ($tuned.within[$key] // [$kind.min, $kind.max]) as [$min, $max]
        | ($max >= 1000 or ($min > 0 and $max > 1000 * $min)) as $log
        | (if $log then [([$min, 0.001] | max), ([$max, 1000] | min)] else [$min, $max] end) as [$low, $high]
        | "\($key) \"--set \($key)=\" \($kind.type[:1])\(if $log then ",log" else "" end) (\($low), \($high))"
    ' > "parameters/$name.txt"
    printf %s "$catalog" | jq -r --arg name "$name" --slurpfile planners planners.json '
        $planners[0][$name] as $tuned
        | (.planners[] | select(.id == $tuned.planner)) as $planner
        | ([$planner.presets[] | select(.name == $tuned.preset) | .values] | add) as $preset
        | [$tuned.keys[] as $key | $preset[$key] // ($planner.params[] | select(.key == $key) | .default)]
        | ($tuned.keys, .) | map(tostring) | join(" ")
    ' > "parameters/$name.default.txt"
done
