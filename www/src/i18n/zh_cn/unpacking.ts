import type { unpackingEn } from '../en/unpacking'

export const unpackingZhCN: typeof unpackingEn = {
  unpacking: 'Formicarium · 正在解压…',
  cut: '此文件不完整：程序部分共 {{whole}} 个字符，此处只有 {{there}} 个。请重新下载或复制。',
  damaged: '此文件已损坏（{{why}}）。请重新下载或复制。',
  failed: '此页面无法启动。换用较新的浏览器也许可行。',
}
