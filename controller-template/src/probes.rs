//! Probes are entries of tables that are read to be compared. With `--cfg count_probes` they are counted where they are made, so that
//! a test can compare them with the bounds that generated modules state; otherwise nothing is left of this.

/// Whether searches are those for processors that guess where a branch leads; with `--cfg count_probes="small"` they are
/// those for the others, so that a test on any machine counts both.
pub(crate) const PREDICTS: bool = cfg!(target_pointer_width = "64") && !cfg!(count_probes = "small");

/// An entry is compared.
#[cfg(not(count_probes))]
#[inline(always)]
pub(crate) const fn probe() {}

#[cfg(count_probes)]
pub(crate) fn probe() {
    COUNT.fetch_add(1, core::sync::atomic::Ordering::Relaxed);
}

#[cfg(count_probes)]
static COUNT: core::sync::atomic::AtomicU32 = core::sync::atomic::AtomicU32::new(0);

/// Probes since the last call.
#[cfg(count_probes)]
#[doc(hidden)]
pub fn take_probes() -> u32 {
    COUNT.swap(0, core::sync::atomic::Ordering::Relaxed)
}
