import type { DictionaryShape } from '../dictionary_shape'
import type { enLabFronts } from '../en/lab_fronts'

/** Chinese of en/lab_fronts.ts. */
export const zhCNLabFronts: DictionaryShape<typeof enLabFronts> = {
  fronts: {
    tab: '权衡',
    first: '横轴',
    second: '纵轴',
    third: '第三项',
    noThird: '无',
    no: '否',
    yes: '是',
    none: '没有找到路径的运行给出这些指标。',
    less: '{{measure}}，越小越好',
    more: '{{measure}}，越大越好',
    reference: '参考点',
    ownReference: '自定参考点',
    over: '指标：{{measures}}。',
    overAgainst: '指标：{{measures}}。参考点：{{reference}}。',
    words: '超体积 {{volume}}，占联合前沿的 {{share}}',
    runs_other: '{{count}} 次运行',
    caption: '前沿与超体积：{{map}}',
    together: '全部参评项',
    columns: {
      volume: '超体积',
      share: '占联合前沿',
      joint: '其上的点',
      alone: '独有',
      own: '自身前沿',
      told: '运行',
      pointRuns: '运行',
      onJoint: '在联合前沿上',
    },
    how: '前沿上的点不被任何运行超越：没有运行在每项指标上都不差且至少一项更好。相同的点算一个点，并计入每个有它的参评项。超体积：在各指标最好值与参考点围成的方框中，被该参评项前沿支配的部分，从 0 到 1。',
    note: '一个点是一次运行，或结果相同的几次运行。大点：在其参评项的前沿上，阶梯线围出前沿支配的部分；带圈：在全部参评项的联合前沿上。',
    noteOfThree:
      '两幅图是同样的点。大点：按三项指标在其参评项的前沿上；带圈：在全部参评项的联合前沿上。',
    referenceNote: '除非自定，参考点比最差的运行还差从最好到最差距离的十分之一。',
    without_other:
      '{{entry}}：{{runs}} 次运行中有 {{count}} 次不是点，没有路径或没有给出某项指标。',
    beyondNote: '并非每项指标都优于参考点的点不计入。',
    files: {
      'fronts-csv': '权衡（CSV）',
      'fronts-markdown': '权衡（Markdown）',
      'fronts-latex': '权衡（LaTeX）',
    },
    filesAbout: {
      'fronts-csv': '每个点及其前沿，每行一个；指标与该标签页相同。',
      'fronts-markdown': '前沿与超体积，每张地图一张表。',
      'fronts-latex': '同上，用于论文；需要 booktabs 与 graphicx 宏包。',
    },
  },
}
