/** Scenarios in the style of the papers: the same files that the recorded comparisons run on, and whom to let race there. */
/** A planner, and the preset of its values. */
export type Racer = [planner: string, preset?: string]

export interface PaperMap {
  id: string
  /** Below experiments/maps, without its ending. */
  file: string
  /** The paper's algorithm, what it is compared with, and the proof. */
  racers: Racer[]
}

const SHIP: Racer[] = [['ship'], ['ant-system', 'ship'], ['any-angle']]
const THRESHOLD: Racer[] = [['acost'], ['acost', 'aco'], ['astar']]

export const paperMaps: PaperMap[] = [
  {
    id: 'paper-fire',
    file: 'fire-20x20',
    racers: [['fire', 'paper'], ['fire', 'basic'], ['tour-exact']],
  },
  { id: 'paper-ship-20', file: 'ship-20x20', racers: SHIP },
  { id: 'paper-ship-30', file: 'ship-30x30', racers: SHIP },
  { id: 'paper-engine-room', file: 'engine-room', racers: SHIP },
  { id: 'paper-threshold-1', file: 'threshold-1', racers: THRESHOLD },
  { id: 'paper-threshold-2', file: 'threshold-2', racers: THRESHOLD },
  {
    id: 'paper-criss-cross',
    file: 'criss-cross-20x20',
    racers: [['fwa-aco'], ['ant-system', 'fireworks'], ['astar']],
  },
]
