import type { DictionaryShape } from '../dictionary_shape'
import type { enReading } from '../en/reading'

export const zhCNReading: DictionaryShape<typeof enReading> = {
  legend: {
    words: '{{name}}：从 {{low}} 到 {{high}}',
    same: '统一标尺',
    constant: '处处为 {{value}}',
    nothing: '尚无数值',
    heights: '高度',
    metres: '{{value}} 米',
    units: {
      trail: 'τ',
      visits: '蚂蚁数',
      heuristic: 'η',
      cost: '格',
      density: '比例',
      'initial-trail': 'τ',
      'seed-path': '',
      priority: '',
    },
    expanded: '已展开',
    onPath: '在路径上',
    elsewhere: '其余',
  },
  cursor: {
    convergence: '{{chart}}：方向键移动光标，Enter 回看，+ 和 − 缩放',
    profile: '{{chart}}：方向键移动光标，Enter 查看单元格，+ 和 − 缩放',
    reset: '显示全部',
    picture: '导出为图片',
    iteration: '第 {{iteration}} 次迭代',
    best: '最优',
    bestOf: '{{planner}}：最优 {{best}}',
    valuesOf: '{{planner}}：最优 {{best}}，本次迭代最优 {{iterationBest}}，平均 {{mean}}',
    distance: '{{distance}} 米处',
    altitude: '海拔',
    cell: '格',
    altitudeOf: '{{planner}}：{{altitude}} 米，格 {{x}}, {{y}}',
    metres: '{{value}} 米',
  },
}
