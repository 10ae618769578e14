//! Events on their way from interrupts to the controller.

use core::sync::atomic::{AtomicU32, Ordering};

use heapless::spsc::{Consumer, Producer, Queue};

/// A queue into which one interrupt puts events, and from which the main loop raises them; neither waits for the other.
///
/// It holds `N - 1` events. With room for each that can be on its way at once it never overflows; if it does,
/// that is counted, and so is an event that came a second time before the controller consumed the first.
///
/// ```
/// use controller_template::EventQueue;
///
/// let mut queue = EventQueue::<char, 4>::new(); // in firmware: a `static_cell`, or a local resource of RTIC
/// let (mut sender, mut receiver) = queue.split();
/// sender.send('a'); // in the interrupt
/// sender.send('b');
/// let mut raised = String::new();
/// receiver.deliver(|event| { // in the main loop: `controller.raise(event)`
///     raised.push(event);
///     true
/// });
/// assert_eq!(raised, "ab");
/// assert_eq!((receiver.lost(), receiver.absorbed()), (0, 0));
/// ```
#[derive(Debug)]
pub struct EventQueue<E, const N: usize> {
    events: Queue<E, N>,
    lost: AtomicU32,
}

/// The interrupt's end of an [`EventQueue`].
///
/// Several interrupts share one as they share anything: in a critical section, or as a resource of RTIC.
pub struct EventSender<'q, E> {
    events: Producer<'q, E>,
    lost: &'q AtomicU32,
}

/// The main loop's end of an [`EventQueue`].
pub struct EventReceiver<'q, E> {
    events: Consumer<'q, E>,
    lost: &'q AtomicU32,
    absorbed: u32,
}

impl<E, const N: usize> EventQueue<E, N> {
    /// An empty queue.
    #[must_use]
    pub const fn new() -> Self {
        EventQueue { events: Queue::new(), lost: AtomicU32::new(0) }
    }

    /// Both ends.
    pub fn split(&mut self) -> (EventSender<'_, E>, EventReceiver<'_, E>) {
        let (producer, consumer) = self.events.split();
        let lost = &self.lost;
        (EventSender { events: producer, lost }, EventReceiver { events: consumer, lost, absorbed: 0 })
    }
}

impl<E, const N: usize> Default for EventQueue<E, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<E> EventSender<'_, E> {
    /// Puts an event into the queue; `false` if it is full, and then the event is lost, and counted.
    pub fn send(&mut self, event: E) -> bool {
        let sent = self.events.enqueue(event).is_ok();
        if !sent {
            // Nobody else writes: no need of an atomic addition, which small processors do not have.
            self.lost.store(self.lost.load(Ordering::Relaxed).saturating_add(1), Ordering::Relaxed);
        }
        sent
    }
}

impl<E> EventReceiver<'_, E> {
    /// Hands every event of the queue to `raise`, the controller's, in the order in which they were sent; says how many.
    ///
    /// Where it returns `false` the event was pending already, and is counted as absorbed.
    pub fn deliver(&mut self, mut raise: impl FnMut(E) -> bool) -> u32 {
        let mut delivered = 0;
        while let Some(event) = self.events.dequeue() {
            delivered += 1;
            if !raise(event) {
                self.absorbed = self.absorbed.saturating_add(1);
            }
        }
        delivered
    }

    /// Whether there is nothing to deliver.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        !self.events.ready()
    }

    /// Events that found the queue full.
    #[must_use]
    pub fn lost(&self) -> u32 {
        self.lost.load(Ordering::Relaxed)
    }

    /// Events that were pending already when they were delivered.
    #[must_use]
    pub const fn absorbed(&self) -> u32 {
        self.absorbed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_is_lost_and_what_is_pending_absorbed() {
        let mut queue = EventQueue::<u8, 3>::new();
        let (mut sender, mut receiver) = queue.split();
        assert!(receiver.is_empty());
        assert_eq!([1, 1, 2, 3].map(|event| sender.send(event)), [true, true, false, false]);
        assert!(!receiver.is_empty());
        let mut pending = crate::Bits::<1>::new([0]);
        assert_eq!(receiver.deliver(|event| pending.insert(event.into())), 2);
        assert!(receiver.is_empty() && pending.ones().eq([1]));
        assert_eq!((receiver.lost(), receiver.absorbed()), (2, 1));
        assert!(sender.send(4));
        assert_eq!(receiver.deliver(|event| pending.insert(event.into())), 1);
        assert_eq!((receiver.lost(), receiver.absorbed()), (2, 1));
    }

    /// An interrupt and the main loop, as two threads: what was sent is lost or comes, each event once and in order.
    #[test]
    fn both_ends_at_once() {
        let mut queue = EventQueue::<u32, 8>::new();
        let (mut sender, mut receiver) = queue.split();
        let mut last = None;
        let mut delivered = 0;
        std::thread::scope(|scope| {
            let sent = scope.spawn(move || (0..100_000).filter(|&event| sender.send(event)).count());
            while !sent.is_finished() || !receiver.is_empty() {
                delivered += receiver.deliver(|event| last.replace(event).is_none_or(|last| last < event));
            }
            assert_eq!(sent.join().ok(), Some(delivered as usize));
        });
        assert_eq!((delivered + receiver.lost(), receiver.absorbed()), (100_000, 0));
    }
}
