//! Checks and runs the subset of IEC 61131-3 Structured Text that controllers are emitted in.
//!
//! This is a tool of tests: what a back end writes is compiled and run by something that knows nothing of the back
//! end. A text goes through the grammar of `tree-sitter-iec61131-3-st`, a static check that refuses what a compiler
//! of the [`Dialect`] would refuse, and a translation in which names are places in a memory of cells, so that
//! tables of 30,000 entries and a `CASE` of thousands of branches run fast.
//!
//! ```
//! use st_evaluator::{Dialect, Unit};
//!
//! let text = "
//! FUNCTION_BLOCK Counter
//! VAR_INPUT go : BOOL; END_VAR
//! VAR_OUTPUT count : UINT; END_VAR
//! VAR edge : R_TRIG; END_VAR
//!   edge(CLK := go);
//!   IF edge.Q THEN count := count + 1; END_IF;
//! END_FUNCTION_BLOCK";
//! let unit = Unit::parse(text, Dialect::Edition2).expect("it compiles");
//! let mut counter = unit.instance("Counter").expect("it is there");
//! for go in [true, true, false, true] {
//!     counter.set("go", go).expect("an input");
//!     let stats = counter.call().expect("it runs");
//!     assert!(stats.statements <= 3);
//! }
//! assert_eq!(counter.int("count"), Ok(2));
//! ```
//!
//! # What there is
//!
//! - `BOOL`, the integers and bit strings, `TIME`, `STRING`; arrays of several dimensions, structures,
//!   enumerations, subranges, other names for types; initial values with repetition.
//! - All sections of variables; `CONSTANT`; [`Instance::retained`] has what `RETAIN` keeps, but no power is ever lost
//!   by itself. `AT` is read, and means nothing.
//! - Functions, function blocks, programs, configurations. One call of a configuration is one scan: every program
//!   runs, whatever its task's interval. What tasks there are, [`Unit::tasks`] tells.
//! - All statements, all operators but `**`; `ABS MIN MAX LIMIT SEL MUX SHL SHR ROL ROR LEN LEFT RIGHT MID CONCAT`,
//!   `X_TO_Y`; `R_TRIG F_TRIG TON TOF TP SR RS CTU` with a clock that [`Instance::advance`] moves.
//! - In CODESYS and TwinCAT: `POINTER TO` elementary types and arrays of them, `ADR`, `p^`, `p[i]`, `SIZEOF`,
//!   `AND_THEN`, `OR_ELSE`, `s[i]` as `BYTE` from 0. In SCL: `s[i]` as `CHAR` from 1, and what the last
//!   section lists.
//!
//! There is no `REAL`, no `WSTRING`, no date, no method, property, interface or namespace, no sequential function
//! chart, no pointer arithmetic, no function that returns more than one cell. What is not supported is an [`Error`]
//! that says so.
//!
//! # What is strict
//!
//! [`Dialect::Edition2`] refuses whatever the second edition does not have or a compiler of it does not take: `//`,
//! `END_IF` without a semicolon, lists without a statement, blocks of variables without a variable, pointers,
//! `CONTINUE`, constant expressions in limits, labels and initial values, names used before their declaration or
//! declared at the top as well, reserved words, double and final underscores, more than 63 characters, implicit
//! conversions of any sort, bit operations on numbers and arithmetic on bit strings, literals that do not fit,
//! labels that overlap, writes to inputs, constants and control variables, assignments between arrays without a
//! common type name, inputs of an instance seen from outside, `VAR_EXTERNAL` or instances in functions, calls of
//! functions as statements, recursion. It is stricter than the standard where compilers differ: names at the top
//! are taken everywhere, and 0 and 1 are not `BOOL`.
//!
//! The other dialects take what their makers document, as far as controllers need it: integers widen, arrays of the
//! same shape are assigned, limits are constant expressions, order does not matter, global variables are visible.
//! SCL wants its semicolons and has no constant arrays.
//!
//! At run time an index out of its range, a division by zero, a value outside of a subrange, a null pointer, a
//! pointer used beyond its object or in a later call than it was taken in (an online change moves variables), a
//! write to a constant through a pointer, a control variable that would wrap around, and too many statements are
//! each a [`RuntimeError`] with a place. Integers wrap around; how often is in [`Stats::wrapped`], because systems
//! compute in different widths and portable texts must not depend on it.
//!
//! # What the grammar does not read
//!
//! It is one of the third edition. Missing from it, and replaced byte for byte before it sees the text (`spelling`
//! has the table): the length of strings in `[ ]`, `Type#value`, `AND_THEN`, `OR_ELSE`, `PERSISTENT`, and SCL's
//! `#name`, `"name"`, `BEGIN`, `REGION`, `VERSION`, `TITLE`, `TYPE` without a colon, organization blocks, instance
//! data blocks, pragmas behind a block's name. Of a repetition with several values, `2(7, 8)`, it makes a call,
//! which is understood.
//!
//! What it cannot read and nothing mends, so that such texts are refused: initial values of arrays in `TYPE` and in
//! structures, and of structures in arrays; nested brackets in initial values; functions without a result (SCL writes
//! `: VOID`, which is read); enumerations with a base type; `NOT q => x`; `R_EDGE` and `F_EDGE` behind a type;
//! comments within comments; `THIS`, `SUPER` and `ADR` as names, which the second edition would allow.

mod arithmetic;
mod code;
mod compile;
mod declare;
mod dialect;
mod error;
mod instance;
mod kind;
mod machine;
mod prelude;
mod reserved;
mod spelling;
mod task;
mod tree;
mod types;
mod unit;
mod value;

pub use dialect::Dialect;
pub use error::{AccessError, Error, RuntimeError};
pub use instance::{Instance, Slot};
pub use machine::Stats;
pub use task::Task;
pub use unit::Unit;
pub use value::Value;
