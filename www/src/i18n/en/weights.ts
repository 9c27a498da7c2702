/** Ground that costs more than its length, and the robot that goes over it. */
export const enWeights = {
  legend: 'Ground costs',
  times: '× {{factor}}',
  orMore: '≥ × {{factor}}',
  hatched: '▨ too narrow',
  cellFactor: 'factor {{factor}}',
  cellNarrow: 'too narrow for the robot',
  picture: 'Grey cells are too narrow for the robot',
  robot: 'Robot',
  sizes: { point: 'A point', round: 'Round' },
  radius: 'Radius (m)',
  radiusHint_one:
    '{{radius}} cell. Cells whose centre is no farther from that of a wall are too narrow.',
  radiusHint_other:
    '{{radius}} cells. Cells whose centre is no farther from that of a wall are too narrow.',
  pointHint: 'It fits wherever a cell is free.',
  cost: 'Costs near obstacles',
  rules: { off: 'Off', 'nav2-smac-2d': 'Nav2 SmacPlanner2D', 'nav2-navfn': 'Nav2 NavFn' },
  inflationRadius: 'Inflation radius (m)',
  scaling: 'Cost scaling factor (1/m)',
  multiplier: 'Cost travel multiplier',
  ruleHints: {
    off: 'A way counts its length, and what the ground costs.',
    'nav2-smac-2d': 'A cell of cost c, 0 to 252, counts 1 + m · c / 252 times its length.',
    'nav2-navfn': 'A cell of cost c, 0 to 252, counts ⌊50 + 0.8 · c⌋ / 50 times its length.',
  },
  noEffect:
    'Cells are {{resolution}} m: an inflation radius this small reaches no further than the walls’ neighbours.',
  noRoom: {
    start: 'The robot does not fit at the start.',
    goal: 'The robot does not fit at a goal.',
  },
  smaller: 'Radius {{radius}} m',
  move: 'Move to the nearest cell that fits',
  needsRoom: 'Shall the robot get room?',
  orSmaller: 'Or make the robot smaller in “Size, moves and robot”.',
  willMove: 'What does not fit moves to the nearest cell that does.',
  nowhere: 'There is no cell in which the robot fits.',
  moved: 'Moved to where the robot fits',
} as const
