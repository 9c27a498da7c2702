/** The text of dialogs: fetched with them (dialogs.ts). */
export const enDialogs = {
  movement: {
    label: 'Allowed moves',
    notes: {
      '4': 'Left, right, up and down; every step is 1 long.',
      '8-both-free':
        'A diagonal step needs both neighbouring cells free, as in the MovingAI benchmarks.',
      '8-one-free': 'A diagonal step needs one of the two neighbouring cells free.',
      '8-always': 'A diagonal step may pass between two walls.',
      '16-both-free':
        'Also two cells on and one aside, if both cells passed are free; diagonal steps need both neighbouring cells free.',
      '16-one-free':
        'Also two cells on and one aside, if both cells passed are free; diagonal steps need one neighbouring cell free.',
      '16-always':
        'Also two cells on and one aside, if both cells passed are free; diagonal steps may pass between two walls.',
    },
  },
  terrain: {
    model: 'How one moves',
    models: {
      surface: 'On the surface',
      slices: 'By slices above it',
    },
    notes: {
      surface: 'From cell to cell over the ground; lengths follow its slopes.',
      slices:
        'From column to column, each step a few cells aside and a few levels up or down, always above the ground: the model of the 3-D textbook colony.',
    },
    maxSlope: 'Steepest slope (°)',
    resolution: 'Cell (m)',
    verticalUnit: 'Unit of heights (m)',
    slices: {
      level: 'Level height (m)',
      levels: 'Levels',
      start_level: 'Start at level',
      goal_level: 'Goal at level',
      max_aside: 'Cells aside in a step',
      max_climb: 'Levels up or down in a step',
    },
    measure: 'Measured by',
    measures: {
      cost: 'Cost',
      length: 'Length alone',
    },
    measureNotes: {
      cost: 'Σ √(1 + Δy² + Δh²) + |h|: every place costs its level, so low paths win.',
      length: 'Σ √(1 + Δy² + Δh²): only the length counts.',
    },
    noPlace:
      'There is no place left for start or goal: choose more or higher levels, or a larger part with known heights.',
  },
  raster: {
    title: 'Open {{name}}',
    open: 'Open {{width}} × {{height}} cells',
    preview: 'The terrain, lit from the north-west; drag to mark a part',
    format: 'Format',
    kinds: {
      'esri-ascii': 'ESRI ASCII grid',
      'height-table': 'Table of heights',
      geotiff: 'GeoTIFF',
      srtm: 'SRTM',
    },
    size: 'Cells',
    cell: 'One cell',
    metres: '{{x}} × {{y}} m',
    heights: 'Heights',
    range: '{{low}} to {{high}}',
    missing: 'No data',
    none: 'none',
    part: 'Part',
    crop: {
      x: 'From column',
      y: 'From row',
      width: 'Columns',
      height: 'Rows',
    },
    whole: 'All of it',
    cropHint: 'Drag on the picture, or give the numbers.',
    cropOutside:
      'The part must lie within {{width}} × {{height}} cells and be 2 cells wide and high.',
    cells: 'Cells of the map',
    presets: 'Most cells a side',
    full: 'As it is',
    square: 'Square cells',
    result: 'A cell will be {{x}} × {{y}} m; “Square cells” makes its sides equal.',
    resultSquare: 'A cell will be {{x}} × {{y}} m.',
    large: 'Runs on so many cells take long.',
  },
  maps: {
    titles: {
      import: 'Import',
      export: 'Export',
      generate: 'Generate a map',
      shape: 'Size and moves',
      shapeTerrain: 'Size, moves and terrain',
    },
    generateNow: 'Generate',
    kindLabel: 'Kind of map',
    width: 'Width',
    height: 'Height',
    density: 'Walls (%)',
    roughness: 'Roughness (%)',
    sides: 'Usual sizes',
    generateHint:
      'The same seed gives the same map on every computer. Start and goals are always connected. Undo brings the present map back.',
    generateTerrainHint:
      'The same seed gives the same terrain on every computer, in cells of 30 m. Undo brings the present map back.',
    resizeTerrainHint:
      'From 2 to {{most}} cells a side. The upper left part is kept; beyond it no height is known, so nothing can be there. Undo brings the rest back.',
    resizeHint:
      'From 2 to {{most}} cells a side. The upper left part is kept, start and goals move into it; undo brings the rest back.',
    chooseFiles: 'Choose files',
    orDrop: 'or drop them anywhere on the page, at any time',
    pasteHere: 'Or paste a map, a scenario or a share link',
    importText: 'Open',
    formats: {
      map: 'MovingAI map (.map)',
      scen: 'MovingAI scenarios (.scen) for the map on show or dropped with it',
      matrix: 'Matrix of 0 (free) and 1 (blocked), with or without separators',
      raster: 'Heights: ESRI ASCII grid (.asc), GeoTIFF (.tif), SRTM (.hgt), table (.csv)',
      json: 'Formicarium scenario, session or comparison (.json)',
      link: 'Share link, or a picture saved here (.png): its session or comparison is in it',
    },
    format: 'Format',
    exports: {
      'movingai-map': {
        name: 'MovingAI map',
        note: 'Cells only. Read by most path planning tools.',
      },
      'movingai-scen': {
        name: 'MovingAI scenario',
        note: 'Start, goal (the first of several) and proven optimal length, to go with the map.',
      },
      matrix: {
        name: '0/1 matrix',
        note: 'Cells only, as MATLAB, NumPy and many papers print them.',
      },
      'esri-ascii': {
        name: 'ESRI ASCII',
        note: 'Heights and cell size as text, without walls, start and goal. Read by every geographic information system.',
      },
      'height-table': {
        name: 'Table of heights',
        note: 'Heights in metres only, a row a line, separated by commas.',
      },
      geotiff: {
        name: 'GeoTIFF',
        note: 'Heights in metres and cell size, one 32-bit number a cell, without walls, start and goal.',
      },
      scenario: {
        name: 'Scenario',
        note: 'Map, movement rule, start, goal and vehicle. Opens here and in the command line tool.',
      },
      experiment: {
        name: 'Session',
        note: 'Everything: scenario, planners, parameters, seed and recorded results.',
      },
    },
    exportFlattens: 'This format has no heights: they will be missing in the file.',
    exportBinary: 'A file of {{bytes}} bytes, not text.',
    preview: 'Preview',
    download: 'Download {{name}}',
  },
  scen: {
    title: 'Choose a scenario',
    count_one: 'One scenario in {{name}} fits this map.',
    count_other: '{{count}} scenarios in {{name}} fit this map.',
    start: 'Start',
    goal: 'Goal',
    optimal: 'Listed optimum',
    choose: 'Use',
  },
  share: {
    title: 'Share this race',
    what: 'Whoever opens the link sees the same map, planners, parameters and seed; the run repeats, and the page says whether the result agrees bit for bit.',
    map: 'Map “{{name}}”, {{width}} × {{height}}',
    terrain: 'Terrain “{{name}}”, {{width}} × {{height}}, with its heights',
    result: 'result after {{iterations}} iterations, digest {{digest}}',
    resultExact_one: 'result after {{count}} expanded cell, digest {{digest}}',
    resultExact_other: 'result after {{count}} expanded cells, digest {{digest}}',
    resultRecorded: 'recorded result, digest {{digest}}',
    noResult: 'no result yet',
    seed: 'Seed {{seed}}',
    link: 'Share link',
    copy: 'Copy link',
    file: 'Save as file',
    picture: 'Save as picture',
    private: '{{length}} characters. Everything is in the link itself; nothing is uploaded.',
    tooLarge:
      'This terrain has more heights than a link can carry. Save the session as a file instead: it opens here by drag and drop.',
    tooLong:
      'This map makes a link of {{length}} characters; many programs cut links beyond {{limit}}. Save the session as a file instead: it carries the same and opens here by drag and drop.',
  },
  help: {
    title: 'Help and keys',
    about:
      'Formicarium runs ant colony planners and exact planners side by side, on one map and with one seed, and measures each against the proven shortest path.',
    step1:
      'Draw on any panel: the first cell decides whether you build or tear down. Drag the start or a goal; add goals with A.',
    step2: 'Change a parameter, a planner or the seed; every run begins again, equal for all.',
    step3: 'Compare gap, turns and effort, then share a link that repeats the very same run.',
    runKeys: 'Anywhere',
    mapKeys: 'On a focused map',
    keys: {
      play: 'Play, pause',
      move: 'One ant move',
      iteration: 'One iteration',
      look: 'Look back: one iteration earlier, later (64 MiB of each run are kept, the rest is computed again)',
      reset: 'Reset all runs',
      end: 'Run to the end',
      undo: 'Undo',
      redo: 'Redo',
      tools: 'Wall, erase, start, goal, add a goal, moves of a cell, pan',
      fit: 'Fit the map',
      relief: 'A terrain in 3-D, and flat again',
      cursor: 'Move the cell cursor',
      apply: 'Use the tool on the cell',
      remove: 'Remove the goal on the cell',
      level: 'By slices: raise, lower the end on the cell',
      turn: 'In 3-D arrows turn it; with Shift: the cell cursor',
      pointer: 'Drag: draw; with the middle button: pan',
      zoom: 'Wheel or pinch: zoom',
      pan: 'Two fingers: pan',
      help: 'This help',
      leave: 'Back to drawing walls',
    },
    scripting:
      'Version {{version}}. For lessons and scripts: window.formicarium in the console offers load, run, results and compare.',
  },
}
