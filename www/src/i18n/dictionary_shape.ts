/** Chinese has one plural form, `_other`. */
export type DictionaryShape<T> = {
  [K in keyof T as K extends `${string}_one` ? never : K]: T[K] extends string
    ? string
    : DictionaryShape<T[K]>
}
