/** What the ground is made of: the panel's picture in the light of the north-west, with contour lines. */
import { Color, DoubleSide, MeshBasicMaterial, MeshLambertMaterial } from 'three'
import type { PanelView } from '../model/messages'
import type { Ground } from '../model/relief_ground'

const LINES = { light: '#4e3a22', dark: '#f0e6d0' }
const LINE_STRENGTH = { light: 0.5, dark: 0.2 }
const PLINTH = { light: '#c9d0cc', dark: '#26302e' }
/** As many lines as on the flat map (src/map/contours.rs). */
const MOST_LEVELS = 15

export interface GroundMaterial {
  material: MeshLambertMaterial
  /** Which lines there are, if any. */
  setLines(ground: Ground, theme: PanelView['theme'], shown: boolean): void
}

export function groundMaterial(): GroundMaterial {
  const material = new MeshLambertMaterial({ side: DoubleSide })
  // The ground gives way to lines that lie on it.
  material.polygonOffset = true
  material.polygonOffsetFactor = 1
  material.polygonOffsetUnits = 4
  const uniforms = {
    lineStep: { value: 1 },
    lineShift: { value: 0 },
    lineColour: { value: new Color() },
    lineStrength: { value: 0 },
  }
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms)
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nvarying float groundLevel;')
      .replace('#include <begin_vertex>', '#include <begin_vertex>\ngroundLevel = position.y;')
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', `#include <common>\n${DECLARATIONS}`)
      .replace('#include <map_fragment>', `#include <map_fragment>\n${LINES_OVER_MAP}`)
  }
  return {
    material,
    setLines(ground, theme, shown) {
      const interval = niceInterval(ground.highest - ground.lowest)
      uniforms.lineStep.value = interval / ground.resolution || 1
      uniforms.lineShift.value = interval > 0 ? ground.lowest / interval : 0
      uniforms.lineColour.value.set(LINES[theme])
      uniforms.lineStrength.value = shown && interval > 0 ? LINE_STRENGTH[theme] : 0
    },
  }
}

export function plinthMaterial(): MeshBasicMaterial {
  return new MeshBasicMaterial({ side: DoubleSide })
}

export function plinthColour(theme: PanelView['theme']): string {
  return PLINTH[theme]
}

const DECLARATIONS = `
varying float groundLevel;
uniform float lineStep;
uniform float lineShift;
uniform vec3 lineColour;
uniform float lineStrength;
float lineAt(float level, float width) {
  float apart = fwidth(level);
  float away = abs(fract(level - 0.5) - 0.5) / max(apart, 1e-6);
  // Where lines crowd together they fade rather than turn the ground dark; level ground has none.
  return (1.0 - smoothstep(width - 0.5, width + 0.5, away)) * (1.0 - smoothstep(0.15, 0.5, apart)) * step(1e-6, apart);
}`

const LINES_OVER_MAP = `
float level = groundLevel / lineStep + lineShift;
float drawn = max(0.6 * lineAt(level, 0.6), lineAt(level / 5.0, 0.85));
diffuseColor.rgb = mix(diffuseColor.rgb, lineColour, lineStrength * drawn);`

/** 1, 2 or 5 times a power of ten; 0 on level ground. */
export function niceInterval(span: number): number {
  if (!(span > 0)) return 0
  const least = span / MOST_LEVELS
  const power = 10 ** Math.floor(Math.log10(least))
  return [1, 2, 5, 10].map((step) => step * power).find((step) => step >= least) ?? 10 * power
}
