/** How a path is to drive: its smooth curve, and what driving costs. */
export const enDriving = {
  curve: 'Smooth curves',
  off: 'Off',
  on: 'On',
  radius: 'Smallest turning radius (m)',
  curvature: 'Largest curvature (1/m)',
  curveHints: {
    off: 'Paths are shown as they are found.',
    on: 'A curve free of walls lies over each path. 0 m: it may turn as tightly as it has to. No search depends on it.',
  },
  energy: 'Energy',
  perMetre: 'Per metre',
  perRadian: 'Per radian turned',
  perMetreUp: 'Per metre climbed',
  energyHints: {
    off: 'Energy is told with smooth curves and robots: {{metre}} per metre, {{radian}} per radian turned, {{up}} per metre climbed.',
    on: 'Energy has the unit of these three numbers, such as joules. No search depends on it.',
  },
} as const
