/** Made by www/service_worker.config.ts. */
declare module 'virtual:files-of-page' {
  /** Every file of the built page; without a revision those whose name changes with their content. */
  export const files: { url: string; revision: string | null; integrity: string }[]
  /** Of all of them together. */
  export const version: string
  export const bytes: number
}
