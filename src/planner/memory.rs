//! What tables hold in memory, for who keeps snapshots of planners.

/// Bytes behind a vector.
pub(crate) fn held<T>(items: &Vec<T>) -> usize {
    items.capacity() * size_of::<T>()
}

/// Bytes behind a vector of vectors.
pub(crate) fn nested<T>(items: &Vec<Vec<T>>) -> usize {
    held(items) + items.iter().map(held).sum::<usize>()
}
