/** What the numbers of the table beside the maps mean: fetched with it. */
export const enMetricHints = {
  metrics: {
    hints: {
      gap: 'How far the result is above the best there is under the same movement rule',
      comparedWith: 'The best there is, by what the planner is measured by',
      order: 'In which order the planner visits the goals',
      plannedLength: 'Sum of the leg lengths by which the order was chosen',
      plannedWeight: 'Sum of planned leg length times the weight b of the goal it leads to',
      walkedWeight: 'The same sum over the legs as walked on the best path',
      unrefinedLength:
        'Length of the path of steps, before line-of-sight refinement made it a polyline',
      length: 'Length of the best path in cells',
      turns: 'Changes of direction along the best path',
      turnIndex: 'Sum of step lengths, each turning step counted 1.2 times',
      minClearance: 'Distance to the nearest wall at the tightest place, in cells',
      meanClearance: 'Distance to the nearest wall on average, in cells',
      travelTime: 'By the scenario’s vehicle: speed, and seconds for every turn',
      lengthMetres: 'Length of the best path over the ground in metres',
      climb: 'Metres up along the best path',
      descent: 'Metres down along the best path',
      steepest: 'Steepest stretch of the best path, up or down',
      levelCost: 'Σ √(1 + Δy² + Δh²) + |h| over the steps, in cells and levels',
      iterations: 'Iterations finished',
      iterationOfBest: 'Iteration in which the best path was found',
      constructedPaths:
        'Complete paths that ants have built or particles and fireworks were read as; samples',
      antMoves: 'Single moves of single ants, steps of decoded paths, or cells along segments',
      cellExpansions: 'Cells a search has looked at',
      digest: 'Fingerprint of path, length and history: equal digests mean equal runs',
    },
  },
}
