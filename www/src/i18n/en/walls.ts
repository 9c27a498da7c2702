/** Walls that change while planners run. */
export const enWalls = {
  label: 'When walls change during a run',
  anew: 'Start anew',
  keep: 'Keep the trails',
  keepNote:
    'Colonies go on with their trails on the new map; searches and swarms begin anew there. What is drawn in one stroke is one change, at the end of an iteration.',
  anewNote: 'Every planner begins anew on the new map.',
  changed: 'Walls change at the end of the iteration; trails stay.',
  beginAnew: 'Begins anew on the new map: {{planners}}',
  most: 'Walls can change {{most}} times in a run: the map was left as it was.',
  ahead: 'Changes of this session’s walls are still ahead: the map was left as it was.',
  aheadHint: 'Let it run until they have been made, or begin anew on the map as it ends.',
  replayed_one: 'Walls of this session change once as it runs.',
  replayed_other: 'Walls of this session change {{count}} times as it runs.',
  replayedHint: 'Each planner has them after the iteration that was noted for it.',
  begin: 'Begin anew on this map',
  made_one: 'Walls have changed once in this run.',
  made_other: 'Walls have changed {{count}} times in this run.',
  failed: 'Walls cannot change in a run now: it has begun anew.',
}
