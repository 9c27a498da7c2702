/**
 * The lessons, in their order: which entries of its question (NAME.toml) race in the session, what the session carries for the lesson,
 * and the numbers that its answer names. `holds` is what the answer says: where it does not hold, nothing is written.
 */

const LENGTH = { objective: 'length' }
const percent = (share) => `${(100 * share).toFixed(1)}%`
const length = (cells) => cells.toFixed(2)
/** By how much `longer` exceeds `shorter`. */
const excess = (longer, shorter) => percent(longer / shorter - 1)

/** Lengths of the two branches of bridge.json. */
const [SHORT, LONG] = [22, 36]

export const LESSONS = [
  {
    id: 'dead-end',
    race: { entries: ['die', 'backtrack', 'chance'], sync: 'iterations', speed: 'move' },
    lesson: { stops: [{ when: 'iteration', iterations: 3 }] },
    measured: ({ line }) => ({
      died: line('die').runs - line('die').with_path,
      back: line('backtrack').with_path,
      backGap: percent(line('backtrack').median_gap),
      chance: line('chance').with_path,
      chanceGap: percent(line('chance').median_gap),
    }),
    holds: ({ line, seeds }) =>
      line('die').with_path === 0 &&
      line('backtrack').with_path === seeds &&
      line('chance').with_path === seeds,
  },
  {
    id: 'bridge',
    race: { entries: ['trails', 'blind'], sync: 'iterations', speed: 'move-2' },
    lesson: { stops: [{ when: 'iteration', iterations: 10 }] },
    measured: (all) => ({
      short: branches(all).short,
      long: branches(all).long,
      blind: percent(onShort(all.plans('blind'))),
      ratio: length(LONG / SHORT),
    }),
    holds: (all) =>
      branches(all).mixed === 0 &&
      branches(all).short >= 0.9 * all.seeds &&
      isHalf(onShort(all.plans('blind'))),
  },
  {
    id: 'stagnation',
    race: { entries: ['ant-system', 'max-min'], sync: 'iterations', speed: 'iteration' },
    lesson: { stops: [{ when: 'stagnation', iterations: 30 }] },
    measured: ({ line, rows, wins, plans }) => ({
      same: plans('ant-system').filter(allOnOne).length,
      median: line('ant-system').median_iteration_of_best,
      latest: latestBest(rows('ant-system')),
      gap: percent(line('ant-system').median_gap),
      limitsGap: percent(line('max-min').median_gap),
      wins: wins('max-min', 'ant-system'),
    }),
    holds: ({ line, rows, wins, plans, seeds }) =>
      plans('ant-system').every(allOnOne) &&
      latestBest(rows('ant-system')) <= 150 &&
      line('ant-system').median_gap > 2 * line('max-min').median_gap &&
      wins('max-min', 'ant-system') >= 0.8 * seeds,
  },
  {
    id: 'evaporation',
    race: { entries: ['little', 'much'], sync: 'iterations', speed: 'moves-16' },
    lesson: { stops: [{ when: 'iteration', iterations: 30 }] },
    measured: ({ line, wins }) => ({
      little: percent(line('little').median_gap),
      much: percent(line('much').median_gap),
      muchIteration: line('much').median_iteration_of_best,
      between: percent(line('between').median_gap),
      beatsLittle: wins('between', 'little'),
      beatsMuch: wins('between', 'much'),
    }),
    holds: ({ line, wins, seeds }) =>
      wins('between', 'little') >= 0.95 * seeds &&
      wins('between', 'much') >= 0.95 * seeds &&
      line('much').median_iteration_of_best < line('between').median_iteration_of_best / 2,
  },
  {
    id: 'alpha-beta',
    race: { entries: ['memory', 'sight', 'both'], sync: 'iterations', speed: 'moves-16' },
    lesson: { stops: [{ when: 'iteration', iterations: 20 }] },
    measured: ({ line, wins }) => ({
      memory: percent(line('memory').median_gap),
      sight: percent(line('sight').median_gap),
      both: percent(line('both').median_gap),
      overMemory: wins('both', 'memory'),
      overSight: wins('both', 'sight'),
    }),
    holds: ({ wins, seeds }) =>
      wins('both', 'memory') >= 0.95 * seeds && wins('both', 'sight') === seeds,
  },
  {
    id: 'corners',
    race: { entries: ['search', 'colony'], sync: 'moves', speed: 'moves-4' },
    lesson: {
      target: { ...LENGTH, beat: 'optimum' },
      drawn: { label: 'cut', path: straightCut() },
    },
    measured: ({ line }) => ({
      bothFree: length(line('search', 'both-free').median),
      oneFree: length(line('search', 'one-free').median),
      always: length(line('search', 'always').median),
      saved: percent(1 - line('search', 'always').median / line('search', 'both-free').median),
      found: Math.min(...RULES.map((rule) => line('colony', rule).optimal)),
    }),
    holds: ({ line, seeds }) =>
      line('search', 'always').worst < line('search', 'one-free').best &&
      line('search', 'one-free').worst < line('search', 'both-free').best &&
      RULES.every((rule) => line('colony', rule).optimal >= 0.95 * seeds),
  },
  {
    id: 'goals',
    race: { entries: ['shortest', 'weighted', 'proven'], sync: 'iterations', speed: 'moves-4' },
    lesson: { stops: [{ when: 'panel-ends' }] },
    measured: ({ line, plans }) => ({
      urgentFirst: urgentFirst(plans('weighted')),
      urgentFirstShortest: urgentFirst(plans('shortest')),
      shortest: length(line('shortest').median),
      weighted: length(line('weighted').median),
      longer: excess(line('weighted').median, line('shortest').median),
      proven: length(line('proven').median),
    }),
    holds: ({ line, plans, seeds }) =>
      urgentFirst(plans('weighted')) >= 0.7 * seeds &&
      urgentFirst(plans('shortest')) === 0 &&
      line('weighted').median > 1.15 * line('shortest').median,
  },
  {
    id: 'terrain',
    race: { entries: ['colony', 'field', 'search'], sync: 'iterations', speed: 'moves-4' },
    lesson: { target: { ...LENGTH, beat: 'optimum' } },
    measured: ({ line, metres }) => ({
      limited: length(line('search', 'limited').median * metres),
      any: length(line('search', 'any').median * metres),
      longer: excess(line('search', 'limited').median, line('search', 'any').median),
      colony: percent(line('colony', 'limited').median_gap),
      field: percent(line('field', 'limited').median_gap),
    }),
    holds: ({ line, wins, seeds }) =>
      line('search', 'limited').best > 1.1 * line('search', 'any').worst &&
      line('colony', 'limited').with_path === seeds &&
      wins('field', 'colony', 'limited') >= 0.95 * seeds,
  },
  {
    id: 'paper-claim',
    race: { entries: ['basic', 'cells', 'improved'], sync: 'iterations', speed: 'moves-16' },
    lesson: { stops: [{ when: 'panel-ends' }] },
    measured: ({ line }) => ({
      basic: length(line('basic').median),
      cells: length(line('cells').median),
      improved: length(line('improved').median),
      total: percent(1 - line('improved').median / line('basic').median),
      colony: percent(1 - line('cells').median / line('basic').median),
      straight: percent(1 - line('basic-straight').median / line('basic').median),
      claimed: percent(1 - PUBLISHED.improved / PUBLISHED.basic),
    }),
    holds: ({ line, wins, seeds }) =>
      wins('improved', 'basic') === seeds &&
      line('basic').median - line('basic-straight').median >
        2 * (line('basic').median - line('cells').median),
  },
  {
    id: 'robot-map',
    race: { entries: ['colony', 'search'], sync: 'moves', speed: 'moves-16' },
    lesson: { target: { ...LENGTH, beat: 'optimum' } },
    measured: ({ line, metres }) => ({
      blocked: length(line('search', 'blocked').median * metres),
      free: length(line('search', 'free').median * metres),
      longer: excess(line('search', 'blocked').median, line('search', 'free').median),
      colony: percent(line('colony', 'blocked').median_gap),
      best: percent(line('colony', 'blocked').best / line('search', 'blocked').best - 1),
    }),
    holds: ({ line, seeds }) =>
      line('search', 'blocked').best > 1.2 * line('search', 'free').worst &&
      line('colony', 'blocked').with_path === seeds &&
      line('colony', 'blocked').optimal === 0,
  },
]

const RULES = ['both-free', 'one-free', 'always']

/** Lengths of the paper's table 2, 20 × 20. */
const PUBLISHED = { basic: 30.275, improved: 27.626 }

/** Iteration after which no run found anything better. */
function latestBest(rows) {
  return Math.max(...rows.map(({ iteration_of_best }) => Number(iteration_of_best)))
}

/** Whether all ants of the last iteration walked paths of one length. */
function allOnOne({ history }) {
  const { iteration_best, iteration_worst } = history.at(-1)
  return iteration_best === iteration_worst
}

/** In how many runs all ants of the last iteration took the short branch, the long one, or not all the same. */
function branches({ plans, seeds }) {
  const runs = plans('trails').map(lastMean)
  const [short, long] = [SHORT, LONG].map((cells) => runs.filter((mean) => mean === cells).length)
  return { short, long, mixed: seeds - short - long }
}

const lastMean = ({ history }) => history.at(-1).iteration_mean

/** Share of the ants of the last iterations that took the short branch. */
function onShort(plans) {
  const shares = plans.map((plan) => (LONG - lastMean(plan)) / (LONG - SHORT))
  return shares.reduce((sum, share) => sum + share, 0) / shares.length
}

const isHalf = (share) => share > 0.4 && share < 0.6

/** In how many runs the most urgent fire of fires.json, the fourth goal, is the first one reached. */
function urgentFirst(plans) {
  return plans.filter(({ tour }) => tour.order[0] === 3).length
}

/** A path that the strictest rule forbids: through the corner at which two walls of corners.json touch, from (8, 7) to (9, 6). */
function straightCut() {
  const along = (y, from, to) => Array.from({ length: to - from + 1 }, (_, i) => [from + i, y])
  const steps = (x, y, dx, dy, count) =>
    Array.from({ length: count }, (_, i) => [x + dx * i, y + dy * i])
  return [
    [2, 6],
    ...along(7, 3, 8),
    ...steps(9, 6, 1, -1, 5),
    ...along(2, 14, 15),
    ...steps(16, 3, 1, 1, 3),
    [19, 5],
  ]
}
