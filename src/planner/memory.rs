//! How many bytes tables hold. Snapshots of planners are kept within a budget of memory.

/// Bytes behind a vector.
pub(crate) fn held<T>(items: &Vec<T>) -> usize {
    items.capacity() * size_of::<T>()
}

/// Bytes behind a vector of vectors.
pub(crate) fn nested<T>(items: &Vec<Vec<T>>) -> usize {
    held(items) + items.iter().map(held).sum::<usize>()
}
