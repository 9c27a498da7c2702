/** The gallery of lessons. Numbers that were measured come from www/lessons/measured.json. */
export const enLessons = {
  title: 'Lessons',
  about:
    'Ten races, each with a question to think about first. Nothing runs before you press play; the answer unfolds when you want it.',
  number: 'Lesson {{number}}',
  copy: 'Copy the link of this lesson',
  file: 'Save this lesson as a file',
  guess: 'Predict first',
  answer: 'What happens, and why',
  measured: 'Measured with {{seeds}} seeds: formicarium compare experiments/lessons/{{id}}.toml',
  next: 'Next lesson',
  all: 'All lessons',
  unknown: 'There is no lesson “{{id}}”.',
  unknownHint: 'Those that there are stand in the menu of maps, under Lessons.',
  cut: 'straight through the corner',
  each: {
    'dead-end': {
      title: 'A dead end without a warning',
      line: 'Ants that die tell nobody',
      labels: 'Ants die\nAnts step back\nBy chance',
      note: 'A blind alley lies between start and goal, open towards the start. In the first panel every ant takes the most probable step, and an ant that is stuck dies. In the second such an ant steps back. In the third ants choose by chance, and die as in the first. You can try to guess their moves: Lesson, Guess its next move.',
      question:
        'Which of the three find a path? Does the first one learn from the ants that it loses?',
      answer:
        'The first never arrives, in {{died}} of {{seeds}} runs. Only ants that arrive leave pheromone. So nothing marks the alley, and the most probable step stays the one that leads into it.\nStepping back suffices: {{back}} of {{seeds}} runs have a path. But all ants take the same one, and it is {{backGap}} longer than the shortest.\nChance suffices too: some ants miss the alley, and the others follow their trail. {{chance}} of {{seeds}} runs have a path, {{chanceGap}} too long in the median.',
    },
    bridge: {
      title: 'The double bridge',
      line: 'How ants that see nothing find the shorter branch',
      labels: 'With trails\nWithout trails',
      note: 'Two branches lead to the goal; by the upper one the way is {{ratio}} times as long. Goss, Aron, Deneubourg and Pasteels gave real ants such a bridge in 1989. The six ants here see nothing (β = 0). In the first panel they follow trails (α = 2), in the second they do not (α = 0).',
      question: 'Where will the ants of the first panel walk in the end? And those of the second?',
      answer:
        'With trails all ants end on one branch. In {{short}} of {{seeds}} runs it is the short one: a shorter path gets more pheromone from each ant, so more ants follow, and leave more.\nIn {{long}} runs it is the long one. By chance more ants took it at first, and a colony does not question what everybody follows.\nWithout trails nothing changes: {{blind}} of the ants walk the short branch in the last iteration.',
    },
    stagnation: {
      title: 'Stagnation',
      line: 'When all ants walk the same path',
      labels: 'Ant System\nBetween limits',
      note: 'Both colonies have 20 ants and 300 iterations. The first is Ant System with strong evaporation, ρ = 0.8. The second is MAX–MIN Ant System: its trails stay between two limits, so that no way is ever given up. The race stops when a colony has found nothing better for 30 iterations.',
      question:
        'How long does the first colony go on improving? What will its 300 iterations bring?',
      answer:
        'Its best path comes in iteration {{median}} in the median of {{seeds}} runs, and in none after iteration {{latest}}. In the last iteration all ants walk the same path, in {{same}} of {{seeds}} runs: nothing new can be found any more. The best path is {{gap}} longer than the shortest in the median.\nBetween limits every step keeps a chance. The median is {{limitsGap}} too long, and the second colony is the better one in {{wins}} of {{seeds}} pairs of equal seed.',
    },
    evaporation: {
      title: 'Evaporation, too little and too much',
      line: 'ρ = 0.01 beside ρ = 1',
      labels: 'Next to none leaves\nAll leaves',
      note: 'ρ is the part of every trail that leaves in an iteration. In the first panel next to nothing leaves, ρ = 0.01. In the second everything does, ρ = 1: ants know the last iteration alone. Both colonies have 50 ants and 100 iterations.',
      question:
        'Which colony stops learning early, and which has hardly begun to? Whose path will be shorter?',
      answer:
        'Too little: the trails of the beginning, equal everywhere, drown what ants add, and they walk almost as at first. The median path is {{little}} longer than the shortest.\nToo much: what one iteration leaves is all that the next one knows. The best path comes as early as iteration {{muchIteration}} in the median, and is {{much}} too long.\nBetween them, with ρ = 0.2, it is {{between}}: better than the first colony in {{beatsLittle}} and than the second in {{beatsMuch}} of {{seeds}} pairs of equal seed. Set ρ beside the maps and see.',
    },
    'alpha-beta': {
      title: 'Memory against sight',
      line: 'α weighs trails, β what an ant sees',
      labels: 'Memory\nSight\nBoth',
      note: 'An ant weighs a step by τ^α · η^β: its trail τ, and η, the nearer the goal the larger. The first colony has memory alone (β = 0), the second sight alone (α = 0), the third both (α = 1, β = 5). Each has 30 ants and 100 iterations.',
      question: 'Who is worse off: ants that see nothing, or ants that remember nothing?',
      answer:
        'Those that remember nothing: their median path is {{sight}} longer than the shortest. Sight leads all ants to the same walls, and no iteration knows more than the one before.\nThose that see nothing come to {{memory}}. They wander at first, but a shorter path gets more pheromone, and the others follow.\nBoth together come to {{both}}: better than memory alone in {{overMemory}} and than sight alone in {{overSight}} of {{seeds}} pairs of equal seed.',
    },
    corners: {
      title: 'May a robot cut corners?',
      line: 'One map, three rules, three lengths',
      labels: 'A*\nColony',
      note: 'Two walls touch at one corner. A diagonal step between them would save a detour; the path by hand takes it. On this map a diagonal step needs both cells beside it free, as a robot does that has a width.',
      question:
        'Why does the path by hand not count? How much shorter would the shortest one be if one cell beside the step had to be free, or none?',
      answer:
        'Both free: {{bothFree}} cells. One free: {{oneFree}}, as corners may be shaved; between the walls both cells beside the step are blocked, and the gap stays closed. None: {{always}}, which is {{saved}} less than with both, straight through a gap into which no real robot fits.\nThe colony finds the shortest path in at least {{found}} of {{seeds}} runs under each rule. Lengths of two papers can be compared only if their rules are the same. Change the rule: Map, “Size, moves and robot”.',
    },
    goals: {
      title: 'Five fires, two orders',
      line: 'The shortest tour is not the most urgent one',
      labels: 'Shortest order\nWeighted order\nProven',
      note: 'A robot visits five fires. D is the most dangerous, C comes next, the others are alike. The first colony makes the way short. The second weighs each leg by how urgent its fire is (Zhang and others 2020). The third panel proves the shortest order.',
      question:
        'Which fire will each of the colonies reach first? How much longer is the way in the weighted order?',
      answer:
        'The weighing colony goes to D first in {{urgentFirst}} of {{seeds}} runs, the other one in {{urgentFirstShortest}}. That has its price: {{weighted}} cells instead of {{shortest}} in the median, {{longer}} more. The proven shortest tour has {{proven}}.\nNo order is the better one as such. What is made small decides: say it beside every length.',
    },
    terrain: {
      title: 'Over the ridge, or around?',
      line: 'What the steepest slope costs',
      labels: 'Colony\nPotential field\nA*',
      note: 'A ridge lies between start and goal, and a saddle to the south of it. The vehicle climbs 20 degrees at most. Two colonies of a paper on terrains race with A*, which proves the shortest way. The key 3 shows it all in three dimensions.',
      question:
        'Where will the shortest way lead? How much shorter would it be for a vehicle that climbs anything?',
      answer:
        'With the limit the shortest way is {{limited}} m long along the ground, without it {{any}} m: the limit makes it {{longer}} longer. It turns away from the flank of the ridge to where slopes are gentle.\nThe first colony stays {{colony}} above the proven way in the median of {{seeds}} runs, the second, whose ants feel a potential field, {{field}}. Change the slope: Map, Size, moves and terrain.',
    },
    'paper-claim': {
      title: 'A paper’s claim, taken apart',
      line: 'Which part of a method does the work?',
      labels: 'Basic\nImproved ants\nWhole method',
      note: 'Fan and others (2026) report paths {{claimed}} shorter than those of a basic colony on a map of 20 × 20 cells: 27.626 instead of 30.275. Their map is a figure; ours is drawn in its style. First the basic colony, then the improved one without its last step, then the whole method: it straightens the best path by line of sight.',
      question:
        'Is the claim true on our map? What earns it: the improved ants, or the straight lines?',
      answer:
        'It is true here: {{improved}} cells against {{basic}} in the median of {{seeds}} runs, {{total}} less.\nThe improved ants alone come to {{cells}}, {{colony}} less, which is as short as steps from cell to cell allow. But straight lines alone earn more: the path of the basic colony, straightened as well, is {{straight}} shorter.\nOf a sum of improvements ask which part does the work.',
    },
    'robot-map': {
      title: 'What the robot has not seen',
      line: 'A map of ROS with unknown cells',
      labels: 'Colony\nA*',
      note: 'A floor as a robot has mapped it, in the form of ROS: walls, free cells of 0.2 m, and a part in the middle that the robot never saw. Unknown cells count as blocked here. Draw your own way beside the planners’: Lesson, Draw a path by hand.',
      question:
        'Where does the way lead? How much shorter would it be if the unseen part were free?',
      answer:
        'It leads around, through the hall: {{blocked}} m. If unseen cells count as free, {{free}} m along the corridor suffice. Caution makes the way {{longer}} longer. The map cannot say what is right; whoever imports it is asked.\nThe colony, which has to find one narrow door after the other, stays {{colony}} above the proven way in the median of {{seeds}} runs and {{best}} in the best one. For one way on a known map a search is the better tool.',
    },
  },
}
