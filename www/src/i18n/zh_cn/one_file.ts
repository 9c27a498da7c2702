import type { DictionaryShape } from '../dictionary_shape'
import type { enOneFile } from '../en/one_file'

/** Chinese of en/one_file.ts. */
export const zhCNOneFile: DictionaryShape<typeof enOneFile> = {
  save: '保存为页面',
  saving: '正在获取页面…',
  hint: '页面是约 {{size}} MB 的单个文件，内含整个程序：双击即可打开，无需网络或安装，会验证所含内容，也可以编辑。它还包含此页面的地址，供其中生成的链接使用。',
  keepsNothing: '此页面是单个文件，不在浏览器中保存任何内容。要保留所做的修改，请再次保存为页面。',
  bare: '此文件没有附带在线 Formicarium 的地址：请把这段文字接在某个地址之后，或保存为页面。',
  unreachable:
    '无法获取页面（{{why}}）。请检查网络后再次按“保存为页面”，或保存为文件：任何 Formicarium 都能打开它。',
}
