//! What features bring to a generated module, each by itself and with the others.

mod generated {
    include!("../benches/step/bench.rs");
}

use generated::bench::{Controller, Saved};

/// A controller that has events pending, and is not in its initial state.
fn busy() -> Controller {
    use generated::bench::Event::{EnvCtlE0000, EnvCtlE0001, EnvCtlE0004, EnvCtlE0006};
    let mut controller = Controller::new();
    for event in [EnvCtlE0000, EnvCtlE0001, EnvCtlE0004, EnvCtlE0006] {
        controller.raise(event);
    }
    let _ = controller.cycle();
    assert!(controller.state() != Controller::new().state() && controller.pending().next().is_some());
    controller
}

#[test]
fn what_was_saved_goes_on() {
    let controller = busy();
    let saved = controller.save();
    assert_eq!(Controller::restore(&saved), Ok(controller.clone()));
    let bytes: [u8; Saved::BYTES] = saved.to_bytes();
    assert_eq!(Saved::from_bytes(&bytes), Ok(saved));
    assert_eq!(saved.table_version(), Controller::TABLE_VERSION);
    assert_eq!(saved.state(), controller.state());
}

#[cfg(feature = "names")]
#[test]
fn names() {
    use generated::bench::{C1Command, Event};
    for event in Event::ALL {
        assert_eq!(Event::from_text(event.text()), Some(event));
    }
    assert_eq!(C1Command::from_text("ctl -> c1.turn(1)"), Some(C1Command::Turn1));
    assert_eq!(C1Command::from_text("ctl -> c2.turn(1)"), None);
}

#[cfg(feature = "serde")]
mod serde {
    use super::{Controller, Saved, busy};
    use crate::generated::bench::{C0Command, C1Command, Commands, Event};
    use controller_template::RestoreError;

    /// Written and read again as JSON and by postcard; returns the JSON and the number of bytes.
    #[track_caller]
    fn check<T>(value: &T) -> (String, usize)
    where
        T: serde::Serialize + for<'de> serde::Deserialize<'de> + PartialEq + std::fmt::Debug,
    {
        let json = serde_json::to_string(value).expect("JSON");
        assert_eq!(serde_json::from_str::<T>(&json).expect("its own"), *value);
        let mut buffer = [0; 256];
        let bytes = postcard::to_slice(value, &mut buffer).expect("it fits");
        assert_eq!(postcard::from_bytes::<T>(bytes).expect("its own"), *value);
        (json, bytes.len())
    }

    #[test]
    fn events_and_commands_are_their_texts_in_every_format() {
        let (json, bytes) = check(&Event::EnvCtlE0003);
        assert_eq!(json, r#""env -> ctl.e0003()""#);
        assert_eq!(bytes, 1 + "env -> ctl.e0003()".len());
        assert_eq!(check(&C0Command::Stop).0, r#""ctl -> c0.stop()""#);
        let commands = Commands { c0: Some(C0Command::Go), c1: None, c2: None };
        assert_eq!(check(&commands).0, r#"{"c0":"ctl -> c0.go()","c1":null,"c2":null}"#);
        let _ = check(&Commands::default());
    }

    #[test]
    fn what_is_no_event_of_these_is_refused() {
        let error =
            serde_json::from_str::<Event>(r#""env -> ctl.gone()""#).expect_err("no event").to_string();
        assert!(error.contains("`sender -> receiver.operation(arguments)`"), "{error}");
        assert!(serde_json::from_str::<Event>("3").is_err());
        assert!(serde_json::from_str::<C1Command>(r#""ctl -> c0.go()""#).is_err());
        // A command to a component that there is no more must not get lost.
        assert!(serde_json::from_str::<Commands>(r#"{"c9":"ctl -> c9.go()","c0":null}"#).is_err());
        // The number of a variant, as a compact format would write it.
        assert!(postcard::from_bytes::<Event>(&[3]).is_err());
    }

    #[test]
    fn saved_states() {
        let saved = busy().save();
        let (json, bytes) = check(&saved);
        let expected = format!(
            r#"{{"table_version":{},"state":{},"pending":[{}]}}"#,
            saved.table_version(),
            saved.state(),
            saved.pending().words()[0]
        );
        assert_eq!(json, expected);
        assert!(bytes <= Saved::BYTES, "{bytes}");
        assert_eq!(Controller::restore(&serde_json::from_str(&json).expect("read")), Ok(busy()));
    }

    /// What no controller saved; bytes would be refused for their check.
    #[test]
    fn what_does_not_exist_is_refused() {
        let own = Controller::TABLE_VERSION;
        let restore = |version: u32, state: u32, pending: u32| {
            let json = format!(r#"{{"table_version":{version},"state":{state},"pending":[{pending}]}}"#);
            Controller::restore(&serde_json::from_str(&json).expect("numbers")).map(|c| c.state())
        };
        assert_eq!(restore(own, 149, 0x7F), Ok(149));
        assert_eq!(restore(own, 150, 0), Err(RestoreError::NoSuchState));
        assert_eq!(restore(own, 256, 0), Err(RestoreError::NoSuchState));
        assert_eq!(restore(own, 0, 0x80), Err(RestoreError::NoSuchEvent));
        assert_eq!(restore(own + 1, 0, 0), Err(RestoreError::OtherTables));
        assert_eq!(restore(0, 0, 0), Err(RestoreError::OtherTables));
        assert!(serde_json::from_str::<Saved>(r#"{"table_version":1,"state":0,"pending":[]}"#).is_err());
    }
}

#[cfg(feature = "defmt")]
#[test]
fn types_have_formats() {
    use generated::bench::{C0Command, Commands, Event};
    // What a log says of them is in the firmware's program `log`.
    fn has_format<T: controller_template::defmt::Format>() {}
    has_format::<Event>();
    has_format::<C0Command>();
    has_format::<Commands>();
    has_format::<Controller>();
    has_format::<Saved>();
    has_format::<controller_template::RestoreError>();
}

#[cfg(feature = "heapless")]
#[test]
fn the_queue_raises_events() {
    use controller_template::EventQueue;
    use generated::bench::Event;
    static QUEUE: static_cell::StaticCell<EventQueue<Event, 4>> = static_cell::StaticCell::new();
    let (mut sender, mut receiver) = QUEUE.init(EventQueue::new()).split();
    let sensor = std::thread::spawn(move || {
        let events = [Event::EnvCtlE0000, Event::EnvCtlE0005, Event::EnvCtlE0000, Event::EnvCtlE0001];
        events.map(|event| sender.send(event))
    });
    assert_eq!(sensor.join().expect("no panic"), [true, true, true, false]);
    let mut controller = Controller::new();
    assert_eq!(receiver.deliver(|event| controller.raise(event)), 3);
    assert!(controller.pending().eq([Event::EnvCtlE0000, Event::EnvCtlE0005]));
    assert_eq!((receiver.lost(), receiver.absorbed()), (1, 1));
}
