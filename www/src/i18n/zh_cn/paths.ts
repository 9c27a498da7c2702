import type { DictionaryShape } from '../dictionary_shape'
import type { enPaths } from '../en/paths'

export const zhCNPaths: DictionaryShape<typeof enPaths> = {
  saveAs: '路径另存为',
  none: '还没有路径。',
  title: '路径',
  whose: '规划器',
  as: '另存为',
  save: '保存路径',
  formats: {
    'path-csv': {
      name: '表格（CSV）',
      note: '格子与米制坐标，每行一个位置。',
    },
    'path-json': {
      name: 'JSON',
      note: '格子与米制坐标，并有地图尺寸、坐标系与长度。',
    },
    'nav-msgs': {
      name: 'ROS 2 路径（YAML）',
      note: 'nav_msgs/msg/Path：以米为单位的位姿，各朝向下一个位置。',
    },
    geojson: {
      name: 'GeoJSON',
      note: '地图坐标系中的一条线，供 QGIS 等软件使用。',
    },
    svg: {
      name: '图形（SVG）',
      note: '墙、起点、目标、路径与比例尺。',
    },
  },
}
