//! Steps generated controllers as the lines of its input say, and prints all that can be seen of them.

use std::collections::BTreeMap;
use std::io::{BufRead as _, Write as _};

use controller_template::{Observer, RestoreError};

type Log = Vec<(Option<usize>, u32, u32)>;

/// A controller with events as positions in table order and commands as codes.
trait Drive {
    fn texts(&self) -> Vec<String>;
    fn raise(&mut self, event: usize) -> bool;
    fn cycle(&mut self, log: &mut Log) -> Vec<u32>;
    fn drain(&mut self, log: &mut Log) -> Vec<u32>;
    fn react(&mut self, event: usize, log: &mut Log) -> Option<Vec<u32>>;
    fn reset(&mut self);
    fn version(&self) -> u32;
    fn save(&self) -> Vec<u8>;
    fn restore(&mut self, saved: &[u8]) -> Result<(), RestoreError>;
    fn state(&self) -> u32;
    fn pending(&self) -> Vec<usize>;
    fn accepted(&self) -> Vec<usize>;
    fn owed(&self) -> Vec<usize>;
}

/// Implements [`Drive`] for the controller of a module; the fields are those of its `Commands`.
macro_rules! drive {
    ($module:ident, $($field:ident),*) => {
        impl Drive for $module::Controller {
            fn texts(&self) -> Vec<String> {
                for event in $module::Event::ALL {
                    assert_eq!($module::Event::from_text(event.text()), Some(event));
                }
                assert_eq!($module::Event::from_text("nothing"), None);
                $module::Event::ALL.iter().map(|event| event.text().to_owned()).collect()
            }

            fn raise(&mut self, event: usize) -> bool {
                self.raise($module::Event::ALL[event])
            }

            fn cycle(&mut self, log: &mut Log) -> Vec<u32> {
                let mut plain = self.clone();
                let commands = self.cycle_observed(&mut Logger(log));
                assert_eq!(plain.cycle(), commands);
                assert_eq!(plain, *self);
                codes(commands)
            }

            fn drain(&mut self, log: &mut Log) -> Vec<u32> {
                let mut plain = self.clone();
                let commands = self.drain_observed(&mut Logger(log));
                assert_eq!(plain.drain(), commands);
                assert_eq!(plain, *self);
                codes(commands)
            }

            fn react(&mut self, event: usize, log: &mut Log) -> Option<Vec<u32>> {
                let mut plain = self.clone();
                let event = $module::Event::ALL[event];
                let commands = self.react_observed(event, &mut Logger(log));
                assert_eq!(plain.react(event), commands);
                assert_eq!(plain, *self);
                commands.map(codes)
            }

            fn reset(&mut self) {
                self.reset();
            }

            fn version(&self) -> u32 {
                Self::TABLE_VERSION
            }

            fn save(&self) -> Vec<u8> {
                self.save().to_bytes().to_vec()
            }

            fn restore(&mut self, saved: &[u8]) -> Result<(), RestoreError> {
                *self = Self::restore(&$module::Saved::from_bytes(saved)?)?;
                Ok(())
            }

            fn state(&self) -> u32 {
                self.state()
            }

            fn pending(&self) -> Vec<usize> {
                for event in $module::Event::ALL {
                    assert_eq!(self.is_pending(event), self.pending().any(|pending| pending == event));
                }
                self.pending().map(index).collect()
            }

            fn accepted(&self) -> Vec<usize> {
                $module::Event::ALL.into_iter().filter(|&event| self.accepts(event)).map(index).collect()
            }

            fn owed(&self) -> Vec<usize> {
                self.owed().map(index).collect()
            }
        }

        struct Logger<'a>(&'a mut Log);

        impl Observer<$module::Event, $module::Commands> for Logger<'_> {
            fn consumed(&mut self, event: $module::Event, source: u32, target: u32) {
                self.0.push((Some(index(event)), source, target));
            }

            fn stepped(&mut self, _: $module::Commands, source: u32, target: u32) {
                self.0.push((None, source, target));
            }
        }

        fn index(event: $module::Event) -> usize {
            $module::Event::ALL.iter().position(|&e| e == event).unwrap()
        }

        #[allow(unused_variables)]
        fn codes(commands: $module::Commands) -> Vec<u32> {
            let codes: Vec<u32> = vec![$(commands.$field.map_or(0, |command| u32::from(command.code()))),*];
            assert_eq!(commands.is_empty(), codes.iter().all(|&code| code == 0));
            codes
        }
    };
}

fn main() {
    let mut controllers: BTreeMap<&str, Box<dyn Drive>> = BTreeMap::new();
    insert_all(&mut controllers);
    let mut out = std::io::BufWriter::new(std::io::stdout().lock());
    let states: Vec<(String, Vec<u8>)> =
        controllers.iter().map(|(name, controller)| ((*name).to_owned(), controller.save())).collect();
    for line in std::io::stdin().lock().lines() {
        let line = line.unwrap();
        let mut words = line.split(' ');
        let module = words.next().unwrap();
        let controller = controllers.get_mut(module).unwrap();
        let action = words.next().unwrap();
        let event = words.next().map(|event| event.parse::<usize>().unwrap());
        let mut log = Log::new();
        let result = match (action, event) {
            ("texts", None) => format!("{:?} {}", controller.texts(), controller.version()),
            ("raise", Some(event)) => controller.raise(event).to_string(),
            ("cycle", None) => format!("{:?}", controller.cycle(&mut log)),
            ("drain", None) => format!("{:?}", controller.drain(&mut log)),
            ("react", Some(event)) => format!("{:?}", controller.react(event, &mut log)),
            ("reset", None) => {
                controller.reset();
                String::new()
            }
            ("reload", None) => {
                let saved = controller.save();
                controller.reset();
                controller.restore(&saved).unwrap();
                String::new()
            }
            ("foreign", None) => {
                for (other, saved) in &states {
                    let restored = controller.restore(saved);
                    assert_eq!(restored.is_ok(), other == module, "{module} goes on from {other}");
                }
                String::new()
            }
            _ => panic!("{line}"),
        };
        let (state, pending) = (controller.state(), controller.pending());
        let (accepted, owed) = (controller.accepted(), controller.owed());
        writeln!(out, "{result} {log:?} {state} {pending:?} {accepted:?} {owed:?}").unwrap();
    }
}
