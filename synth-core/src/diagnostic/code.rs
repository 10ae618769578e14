//! The one table of diagnostic codes and their long texts (`sml explain CODE`).

use std::fmt;

macro_rules! codes {
    ($($variant:ident = $number:literal, $title:literal, $text:literal;)*) => {
        /// A stable diagnostic code; printed as `SML0007`.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum Code {
            $(#[doc = $title] $variant = $number,)*
        }

        impl Code {
            /// Every code, in order.
            pub const ALL: &'static [Code] = &[$(Code::$variant),*];

            /// A few words: what this code is about.
            pub fn title(self) -> &'static str {
                match self { $(Code::$variant => $title,)* }
            }

            /// The long text: what is wrong, why it is refused, how to mend it.
            pub fn explanation(self) -> &'static str {
                match self { $(Code::$variant => $text,)* }
            }
        }
    };
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "SML{:04}", *self as u16)
    }
}

// 1 to 19: lexis and syntax; 20 to 49: names and types; 50 to 69: play-out; 70 to 89: the game; 90 up: warnings.
codes! {
    Lexical = 1, "text that is not a token",
        "The text contains a character or an unfinished token that SML does not know.\n";

    UnknownName = 20, "a name that is declared nowhere",
        "Every class, enum, object, role, attribute, operation, variable and literal must be declared before it means \
         anything.\nThe help names the declared one that is spelled most alike. A message's operation is looked up in \
         the class of its receiver and the classes that it inherits from; `setX` exists for every attribute `x`.\n";
    DuplicateName = 21, "a name that is declared twice",
        "Classes, enums and objects share one name space; a dynamic role may not be named like an object; attributes \
         and operations must be unique in their class and what it inherits from, `setX` for an attribute `x` \
         included.\nThe error is at the second declaration and also points at the first.\n";
    TypeMismatch = 22, "a value of the wrong type",
        "A value must fit where it is used: conditions are `bool`, arithmetic and `<` are for integers, `==` compares \
         values of one type, a class-typed place takes an object of that class or of a subclass, or `null`.\nA \
         message argument may also be of a superclass; it then matches only what fits.\n";
    ArgumentCount = 23, "the wrong number of arguments",
        "A message gives one argument for each declared parameter of its operation; `*` stands for any value. A message \
         without parentheses has no arguments.\n";
    ReadBeforeBound = 24, "a variable or role that is read before it has a value",
        "A variable gets its value from its declaration, an assignment or `bind`; a dynamic role from a message in \
         which it sends or receives, or from `bindings`. On every way to this place that must have happened: what one \
         case of an `alternative` or one round of a `while` binds is not bound behind it.\n";
    UnboundRole = 25, "a message to be sent, with an unbound role",
        "A message that the system must send needs to know who sends and who receives. Its dynamic roles must be bound \
         by an earlier message of the scenario or by `bindings [ role = … ]`.\n";
    NoControllableClass = 26, "no controllable class",
        "The section `controllable { … }` names the classes whose objects are the system. Without one there is nothing \
         to build a controller for.\n";
    EmptyScenario = 27, "a scenario without fragments",
        "A scenario says something about messages; an empty one can neither start nor be violated.\n";
    OutOfRange = 28, "a constant outside its range",
        "An integer must lie within the range of the attribute, parameter or variable that takes it, and a range must \
         contain at least one value and at most 2^32.\n";
    SilentLoop = 29, "a loop that could spin",
        "Every way through the body of a `while` needs a message or a `wait`; otherwise it could come round for ever \
         without anything happening. An `alternative` all of whose cases have conditions may be passed.\n";
    CyclicInheritance = 30, "a class that inherits from itself",
        "The bases of a class must end somewhere.\n";
    ControllableInAssumption = 31, "an assumption that obliges the system",
        "An assumption promises what the environment does. A message with a modality in it must therefore have a sender \
         that is not controllable; what the system must do belongs into a guarantee.\n";
    TooLarge = 32, "a scenario that is too large",
        "A scenario can have 65,534 fragments. Split it.\n";

    PlayOutRange = 50, "a value that leaves its range during play-out",
        "Some play reaches a state in which an event that can really happen gives an attribute, a variable or an \
         argument a value outside its range. The play is shown. Widen the range, or forbid the event there with a \
         condition or a constraint.\n";
    PlayOutNull = 51, "a path through `null` during play-out",
        "Some play reaches a state in which an attribute of `null` is read or written. The play is shown. Test for \
         `null` first: `a.b != null && a.b.c`.\n";
    PlayOutLoop = 52, "a loop that never settles",
        "Some play reaches a state in which a `while` comes round to the same place with the same values within one \
         step, because the `wait`s in it pass at once. The play is shown. Wait for something that changes.\n";
    ViolatedInitially = 53, "a scenario that is violated from the start",
        "A scenario that starts at once is settled in the initial state; this one is violated there already.\n";
    LimitReached = 54, "a limit was reached",
        "The state space is larger than `--max-states` or `--max-memory` allow. Raise the limit, or make the \
         specification smaller: fewer objects, narrower ranges, more assumptions about what the environment does.\n";

    Unrealizable = 70, "a specification that no controller can meet",
        "Whatever the controller does, the environment can keep all assumptions and make it break or starve a \
         guarantee. A play is shown. Add the assumption that rules it out, or relax a guarantee.\n";
    VerificationFailed = 71, "a controller that does not meet the specification",
        "The product of controller and specification contains the play shown.\n";
}
