//! Games made by hand.
