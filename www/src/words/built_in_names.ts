/** What the built-in maps are called in files and links, where their key does not go along. */
const KEYS: Record<string, string> = {
  'Two corridors': 'two-corridors',
  'Scattered blocks, 20 × 20': 'aco-20x20',
  'Engine room': 'engine-room',
  Rooms: 'rooms',
  Maze: 'maze',
  'Random, 100 × 100': 'random-100',
  'Open field': 'open-field',
  Unreachable: 'unreachable',
  Hills: 'terrain-hills',
  'Rough ground': 'terrain-slices',
  'Five places, 20 × 20': 'paper-fire',
  'Compartment, 20 × 20': 'paper-ship-20',
  'Compartment, 30 × 30': 'paper-ship-30',
  'Engine room, 40 × 30': 'paper-engine-room',
  'Threshold environment I, 20 × 20': 'paper-threshold-1',
  'Threshold environment II, 20 × 20': 'paper-threshold-2',
  'Criss-cross, 20 × 20': 'paper-criss-cross',
}

export const builtInCalled = (name: string) => (Object.hasOwn(KEYS, name) ? KEYS[name] : undefined)
