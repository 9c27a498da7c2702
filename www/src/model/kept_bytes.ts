/** For snapshots of a panel's run, by which one can look back at it; what is not kept is computed again. */
export const KEPT_BYTES = 64 * 1024 * 1024
