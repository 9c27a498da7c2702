/** What figures need of the plotting library, fetched when the first of them is looked at; the rest of it stays behind. */
export {
  areaY,
  axisX,
  axisY,
  dot,
  gridX,
  gridY,
  line,
  plot,
  rect,
  ruleX,
  ruleY,
  text,
} from '@observablehq/plot'
