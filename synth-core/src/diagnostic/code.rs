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

            /// The code that is written `SML0007`, `sml7` or `7`.
            #[must_use]
            pub fn from_text(text: &str) -> Option<Code> {
                let digits = text.trim_start_matches(|c: char| c.is_ascii_alphabetic());
                let prefix = &text[..text.len() - digits.len()];
                let number = Some(digits).filter(|_| prefix.is_empty() || prefix.eq_ignore_ascii_case("sml"))?;
                let number: u16 = number.parse().ok()?;
                Code::ALL.iter().copied().find(|&code| code as u16 == number)
            }

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

// 1 to 19: lexis and syntax; 20 to 49: names and types; 50 to 69: play-out; 70 to 89: the game; 90 to 99: warnings; 100 to 119:
// the command `sml`; 120 to 139: plants, with their warnings from 130; 140 up: what is made of plants.
codes! {
    Lexical = 1, "text that is not a token",
        "The text contains a character that begins no token. SML uses the tokens of Rust, so that the same text can\n\
         stand in a file and in a macro; characters outside ASCII, `\\`, a backtick and single quotes occur only in\n\
         comments and in the strings of imports. Raw strings and raw identifiers do not exist.\n\n\
         Wrong:  class Price { value: 0..=9 € }\n\
         Right:  class Price { value: 0..=9 }\n";
    Delimiter = 2, "delimiter without its partner",
        "A `{`, `[` or `(` is never closed, or a closing one closes nothing or stands where another is due. When the\n\
         partner is missing at the end of the text, the indentation of the lines decides which opening one is shown:\n\
         the first whose supposed partner stands further to the left. Nothing behind this place can be read reliably,\n\
         so further mistakes there show only when it is mended.\n\n\
         Wrong:  wait [arm.free\n\
         Right:  wait [arm.free]\n";
    Unterminated = 3, "string or comment without its end",
        "A string ends with `\"` on the line where it begins, a block comment with `*/`; block comments nest, so each\n\
         `/*` inside one needs a `*/` of its own. All text behind an unfinished one belongs to it.\n\n\
         Wrong:  import \"cell.sml\n\
         Right:  import \"cell.sml\"\n";
    Syntax = 4, "token out of place",
        "The tokens are SML's own, but not in an order that the grammar knows; the message says what could stand at\n\
         this place. Arguments, parameters and enum literals are separated by `,`; a `;` may end any fragment,\n\
         declaration or effect assignment. The reader goes on behind the construct, so one run shows several mistakes.\n\n\
         Wrong:  eventually controller arm.pickUp()\n\
         Right:  eventually controller -> arm.pickUp()\n";
    Reserved = 5, "keyword used as a name",
        "Words that open or modify a construct of SML are not names: the reader could not tell one from the other.\n\
         The keywords of Rust are free: an operation may be called `move` and an attribute `type`.\n\n\
         Wrong:  class Belt { wait() }\n\
         Right:  class Belt { waitForBlank() }\n";
    NameForm = 6, "name of a form that SML does not allow",
        "A name is a letter followed by letters, digits and `_`, all of them ASCII: names go into Rust and into the\n\
         languages of programmable controllers, which allow no more than that.\n\n\
         Wrong:  object _türe: Door\n\
         Right:  object tuere: Door\n";
    NumberForm = 7, "number that is not a plain decimal integer",
        "Integers are written with decimal digits alone: no other base, no `_` between digits, no suffix, no fraction\n\
         and no exponent. The two ends of a range have two dots between them.\n\n\
         Wrong:  level: 0..=0x10\n\
         Right:  level: 0..=16\n";
    NumberRange = 8, "integer beyond 64 bits",
        "Integers lie between -9223372036854775808 and 9223372036854775807, and so does all arithmetic. Ranges of\n\
         attributes and parameters should be far smaller, since every value can be a state of its own.\n\n\
         Wrong:  count: 0..=99999999999999999999\n\
         Right:  count: 0..=99\n";
    OldType = 9, "type of an older dialect",
        "`EBoolean`, `EInt` and `EString` belong to specifications over an Ecore model. A finite game needs finite\n\
         types: `bool`, a range of integers, an enum, or a class.\n\n\
         Wrong:  var EInt floor\n\
         Right:  var 1..=3 floor\n";
    Empty = 10, "no specification and no plant in the text",
        "A file holds imports and then exactly one specification, or exactly one plant; this one holds nothing but space\n\
         and comments.\n\n\
         Right:  specification Name { … }\n";
    TooDeep = 11, "nesting too deep",
        "Braces, brackets, parentheses and expressions nest up to a fixed depth that nothing written by hand\n\
         comes near, so that a broken generator cannot exhaust the stack. Give a part of the expression a variable of\n\
         its own, or split the scenario.\n\n\
         Wrong:  wait [((((…((((a))))…))))]\n\
         Right:  wait [a]\n";
    Encoding = 12, "file that is not UTF-8",
        "Specifications are UTF-8 text, with or without a byte order mark. Open the file in an editor with its real\n\
         encoding, often Latin-1 or UTF-16, and store it again as UTF-8.\n";
    ComparisonChain = 13, "comparisons in a chain",
        "Comparisons do not chain: `a < b < c` would compare a truth value with `c`. Say which comparisons are meant,\n\
         or put the inner one in parentheses.\n\n\
         Wrong:  wait [1 < lift.level < 3]\n\
         Right:  wait [1 < lift.level && lift.level < 3]\n";

    UnknownName = 20, "a name that is declared nowhere",
        "Every class, enum, object, role, attribute, operation, variable and literal must be declared before it means\n\
         anything. The help names the declared one that is spelled most alike. A message's operation is looked up in\n\
         the class of its receiver and the classes that it inherits from; `setX` exists for every attribute `x`. A\n\
         name that is unknown in several places is told once, with the other places as labels. In a plant the same holds for\n\
         inputs, outputs, events, automata and their states.\n\n\
         Wrong:  urgent controller -> lmap.on()\n\
         Right:  urgent controller -> lamp.on()\n";
    DuplicateName = 21, "a name that is declared twice",
        "Classes, enums and objects share one name space; a dynamic role may not be named like an object; attributes\n\
         and operations must be unique in their class and what it inherits from, `setX` for an attribute `x`\n\
         included. In a plant signals, events, and automata with constraints are three name spaces, and the states of each\n\
         automaton are one. The error is at the second declaration and also points at the first.\n\n\
         Wrong:  object lamp: Lamp\n\
         Right:  object lamp2: Lamp\n";
    TypeMismatch = 22, "a value of the wrong type",
        "A value must fit where it is used: conditions are `bool`, arithmetic and `<` are for integers, `==` compares\n\
         values of one type, a class-typed place takes an object of that class or of a subclass, or `null`. A message\n\
         argument may also be of a superclass; it then matches only what fits.\n\n\
         Wrong:  wait [lamp.level]\n\
         Right:  wait [lamp.level > 0]\n";
    ArgumentCount = 23, "the wrong number of arguments",
        "A message gives one argument for each declared parameter of its operation; `*` stands for any value. A message\n\
         without parentheses has no arguments.\n\n\
         Wrong:  urgent controller -> lamp.dim()\n\
         Right:  urgent controller -> lamp.dim(1)\n";
    ReadBeforeBound = 24, "a variable or role that is read before it has a value",
        "A variable gets its value from its declaration, an assignment or `bind`; a dynamic role from a message in\n\
         which it sends or receives, or from `bindings`. On every way to this place that must have happened: what one\n\
         case of an `alternative` or one round of a `while` binds is not bound behind it.\n\n\
         Wrong:  var bool seen  wait [seen]\n\
         Right:  var bool seen = true  wait [seen]\n";
    UnboundRole = 25, "a message to be sent, with an unbound role",
        "A message that the system must send needs to know who sends and who receives. Its dynamic roles must be bound\n\
         by an earlier message of the scenario or by `bindings [ role = … ]`. In the examples `some` is a dynamic role.\n\n\
         Wrong:  urgent controller -> some.on()\n\
         Right:  some -> controller.asked()  urgent controller -> some.on()\n";
    NoControllableClass = 26, "no controllable class",
        "The section `controllable { … }` names the classes whose objects are the system; whatever inherits from them\n\
         belongs to it, too. Without one there is nothing to build a controller for.\n\n\
         Wrong:  specification Cell { controllable { } }\n\
         Right:  specification Cell { domain { class Arm { } } controllable { Arm } }\n";
    EmptyScenario = 27, "a scenario without fragments",
        "A scenario says something about messages; an empty one can neither start nor be violated.\n\n\
         Wrong:  guarantee scenario Later { }\n\
         Right:  guarantee scenario Lights { user -> controller.pressed() urgent controller -> lamp.on() }\n";
    OutOfRange = 28, "a constant outside its range",
        "An integer must lie within the range of the attribute, parameter or variable that takes it, and a range must\n\
         contain at least one value and at most 2^32. Both ends of a range belong to it.\n\n\
         Wrong:  urgent controller -> lamp.dim(4)\n\
         Right:  urgent controller -> lamp.dim(3)\n";
    SilentLoop = 29, "a loop that could spin",
        "Every way through the body of a `while` needs a message or a `wait`; otherwise it could come round for ever\n\
         without anything happening. An `alternative` all of whose cases have conditions may be passed.\n\n\
         Wrong:  while [lamp.lit] { alternative [lamp.level > 0] { user -> controller.pressed() } }\n\
         Right:  while [lamp.lit] { user -> controller.pressed() }\n";
    CyclicInheritance = 30, "a class that inherits from itself",
        "The bases of a class must end somewhere; here they come round to the class itself.\n\n\
         Wrong:  domain { class Arm : Robot { } class Robot : Arm { } }\n\
         Right:  domain { class Arm : Robot { } class Robot { } }\n";
    ControllableInAssumption = 31, "an assumption that obliges the system",
        "An assumption promises what the environment does. A message with a modality in it must therefore have a\n\
         sender that is not controllable; what the system must do belongs into a guarantee.\n\n\
         Wrong:  assumption scenario Answers { user -> controller.pressed() urgent controller -> lamp.on() }\n\
         Right:  assumption scenario Answers { controller -> lamp.on() eventually lamp -> controller.asked() }\n";
    TooLarge = 32, "a scenario that is too large",
        "A scenario can have 65,536 fragments, cases and branches, its body and those in it included. Split it into\n\
         several scenarios.\n";

    MissingImport = 33, "an imported file that cannot be read",
        "The path of an `import` is relative to the file that it stands in; in the macro `sml!` and in the path that is\n\
         given to it, relative to the folder of the package. A folder, a device, or a file of more than 16 MiB is no\n\
         specification.\n";
    CyclicImport = 34, "files that import each other",
        "Imports must not form a circle. The error is at the string that closes it. A file that is imported several\n\
         times is merged once, so common parts can be imported wherever they are needed.\n";

    PlayOutRange = 50, "a value that leaves its range during play-out",
        "Some play reaches a state in which an event that can really happen gives an attribute, a variable or an\n\
         argument a value outside its range. The shortest such play is shown. Widen the range, or forbid the event\n\
         there with a condition or a constraint.\n\n\
         Wrong:  var 0..=3 n = 0  while { user -> controller.pressed() n = n + 1 }\n\
         Right:  var 0..=3 n = 0  while [n < 3] { user -> controller.pressed() n = n + 1 }\n";
    PlayOutNull = 51, "a path through `null` during play-out",
        "Some play reaches a state in which an attribute of `null` is read or written. The shortest such play is\n\
         shown. Test for `null` first: `&&`, `||` and `=>` do not ask their right side where the left one decides.\n\n\
         Wrong:  wait [lamp.next.lit]\n\
         Right:  wait [lamp.next != null && lamp.next.lit]\n";
    PlayOutLoop = 52, "a loop that never settles",
        "Some play reaches a state in which a `while` comes round to the same place with the same values within one\n\
         step, because the `wait`s in it pass at once. The shortest such play is shown. Wait for something that\n\
         changes.\n\n\
         Wrong:  while { wait [!lamp.lit] }\n\
         Right:  while { wait [!lamp.lit] user -> controller.pressed() }\n";
    ViolatedInitially = 53, "a scenario that is violated from the start",
        "A scenario that starts at once is settled in the initial state; this one is violated there already.\n\n\
         Wrong:  guarantee scenario Dark { violation [!lamp.lit] }\n\
         Right:  guarantee scenario Dark { user -> controller.pressed() violation [lamp.lit] }\n";
    LimitReached = 54, "a limit was reached",
        "The state space, or what is made of it, is larger than `--max-states` or `--max-memory` allow, or than the\n\
         machine's memory where no limit is given. Raise the limit, or make what is described smaller: fewer objects,\n\
         narrower ranges, more assumptions about what the environment does; fewer components, or a part of the plant.\n\
         In the macros `sml!` and `plant!` the limit is fixed, and lower still in an editor; a build script\n\
         (`synth_core::build`) has none. The exit code is 3.\n";

    Unrealizable = 70, "a specification that no controller can meet",
        "Whatever the controller does, the environment can keep all assumptions and make it break or starve a\n\
         guarantee. A play is shown. Add the assumption that rules it out, or relax a guarantee.\n";
    VerificationFailed = 71, "a controller that does not meet the specification",
        "The product of controller and specification contains the play shown: it breaks a guarantee, or starves one\n\
         while all assumptions are kept. If the controller comes from this tool, that is a mistake of the tool.\n";
    EndlessSuperStep = 72, "a specification that only an endless super step meets",
        "A play counts as won when an assumption is open for ever, and the environment cannot meet an assumption while\n\
         the system keeps the turn. So by the letter of the winning condition the system wins by sending messages\n\
         without end. No controller can do that in a cycle, and no play in which super steps end is won by the system\n\
         here. Let the loop wait for an event of the environment, or relax the guarantee that needs it.\n\n\
         Wrong:  while { eventually controller -> lamp.on() }\n\
         Right:  while { user -> controller.pressed() eventually controller -> lamp.on() }\n";

    SystemBreaksAssumption = 90, "an assumption that the controller could break",
        "In some state a guarantee asks for an event of the system that violates an assumption. A controller must not\n\
         win by breaking its environment, so by default the event is not executable there and the controller has to do\n\
         without it; with `--classic` it may happen and wins the game. Either the guarantee asks too early or the\n\
         assumption is about something that the system decides. The play that leads there is shown.\n\n\
         Wrong:  guarantee scenario G { user -> ctl.go() urgent ctl -> arm.move() }\n        \
         assumption scenario A { ctl -> arm.move() strict eventually arm -> ctl.done() }\n\
         Right:  guarantee scenario G { user -> ctl.go() wait [!arm.moving] urgent ctl -> arm.move() }\n";
    SystemOnlyWait = 91, "an assumption that waits for what the environment does not change",
        "`wait eventually` in an assumption promises that the environment makes the condition true some day. But no event\n\
         of the environment changes anything that the condition reads, so only the system could keep the promise. A\n\
         controller wins by leaving it open for ever, and then owes nothing. What the system has to bring about belongs\n\
         into a guarantee.\n\n\
         Wrong:  effects { Controller -> Lamp.light() { receiver.on = true } }\n        \
         assumption scenario A { user -> ctl.ask() wait eventually [lamp.on] }\n\
         Right:  guarantee scenario G { user -> ctl.ask() wait eventually [lamp.on] }\n";
    Trapped = 92, "a controller that leaves its environment no way on",
        "In the controlled system a state is reached from which the environment cannot keep its assumptions, whatever it\n\
         does: an assumption promises an event that cannot happen any more. By the winning condition the system then wins\n\
         every play, and the controller may stop doing its work. Either a guarantee or an effect rules out the event that\n\
         is promised, or the assumption promises too much. The play that leads there is shown.\n\n\
         Wrong:  assumption scenario A { ctl -> arm.move() strict eventually arm -> ctl.done() }\n        \
         assumption scenario B { user -> ctl.stop() user -> ctl.go() } constraints [ forbidden arm -> ctl.done() ]\n\
         Right:  assumption scenario A { ctl -> arm.move() eventually arm -> ctl.done() }\n        \
         constraints [ interrupt user -> ctl.stop() ]\n";
    NeverStarts = 93, "a scenario that can never start",
        "A copy of a scenario starts when its first message happens. No play of this specification contains such an event,\n\
         so the scenario says nothing. The note says why: nobody sends it, a constant lies outside the parameter's range,\n\
         no channel links the two objects, or the event is not spontaneous and no assumption causes it.\n\n\
         Wrong:  parameter ranges { Lift.call(floor = [1..3]) }  …  user -> lift.call(4)\n\
         Right:  parameter ranges { Lift.call(floor = [1..4]) }  …  user -> lift.call(4)\n";
    Vacuous = 94, "a guarantee that the controlled system never needs",
        "In every play of controller and environment this guarantee either does not start or never comes to a place where\n\
         it asks for something or forbids it. It is met because nothing happens that it speaks of: often a sign that\n\
         another scenario keeps the system from ever getting there, or that a first message is not the one that was meant.\n";
    OrderMatters = 95, "two events of the environment whose order makes a difference",
        "In some state of the controlled system either of two events can come, and what the controller does, or where it\n\
         ends, depends on which is first; or only one order is allowed, and after the other the second event fits nowhere.\n\
         A programmable controller samples its inputs: both may come in one scan, and then they are taken in table order,\n\
         which is the order of their texts. See to it that this order is right, that both cannot come within one cycle\n\
         time, or write the scenarios so that the order makes no difference. The play that leads there is shown.\n";
    CoveredSiblings = 96, "a message with `bind` that catches more than it names",
        "All messages of a scenario count while a copy is active, and one with `bind v` matches every value. So after\n\
         `controller -> arm.moveTo(bind t)`, while a `strict` message is due, every other `moveTo` of that arm is \"another\n\
         message of the scenario\" and violates it, not only `moveTo(t)`. Here such an event is wanted or could come at that\n\
         moment. If it is to be forbidden, say so; if each value is to be followed on its own, say that others do not\n\
         concern the copy.\n\n\
         Wrong:  { ctl -> arm.moveTo(bind t)  strict eventually arm -> ctl.arrivedAt(t) }\n\
         Right:  { … } constraints [ ignore ctl -> arm.moveTo(*) ]\n\
         Right:  { … } constraints [ forbidden ctl -> arm.moveTo(*) ]\n";
    Unused = 97, "a declaration that nothing uses",
        "A class, enum, object, role, attribute, operation, variable, effect, or an entry about an event, without which the\n\
         specification would mean the same. Often a name was mistyped elsewhere or a scenario forgotten. Attributes and\n\
         variables that are written but never read make states different that need not be. Declarations of imported files\n\
         are not reported, for another specification may use them. In a plant it is a signal that no formula and no command\n\
         names, or an event that no automaton names.\n\n\
         Wrong:  var 1..=3 floor  user -> ctl.call(bind floor)  urgent ctl -> lift.go()\n\
         Right:  user -> ctl.call(*)  urgent ctl -> lift.go()\n";
    NeverCaused = 98, "an event that waits for a cause and has none",
        "An event under `non-spontaneous events` can happen only while a copy of an assumption is at a message with a\n\
         modality (`eventually`, `urgent`, `requested` or `committed`) that it matches. A message without one only waits for\n\
         the event, and the first message of a scenario only starts it: neither causes anything. So this event never\n\
         happens.\n\n\
         Wrong:  assumption scenario A { ctl -> arm.pickUp()  arm -> ctl.pickedUp() }\n\
         Right:  assumption scenario A { ctl -> arm.pickUp()  eventually arm -> ctl.pickedUp() }\n";
    NotNeeded = 99, "an assumption that no guarantee needs",
        "If this assumption is relaxed, so that the environment may break it and need not meet its obligations, a controller\n\
         still exists. The fewer assumptions a controller relies on, the more environments it fits. An assumption that only\n\
         causes events goes on causing them when relaxed. Remove it, or make it weaker, unless it is there to document the\n\
         plant.\n";

    Usage = 100, "wrong usage",
        "The arguments make no sense together. `sml --help` and `sml COMMAND --help` say what can be asked. The exit\n\
         code is 2.\n";
    Unsupported = 101, "something that is not supported yet",
        "The name is part of the interface, but this version does nothing under it yet. `sml --help` lists what it\n\
         does. The exit code is 2.\n";
    Unreadable = 102, "a file that cannot be opened",
        "The file does not exist, is a folder or larger than a specification or a plant can be, or may not be read; `-`\n\
         stands for the standard input. The exit code is 4.\n";
    Unwritable = 103, "an output that cannot be written",
        "The folder does not exist, or it or the file may not be written. Files are written whole or not at all: what\n\
         was there before is untouched. The exit code is 4.\n";
    MalformedController = 104, "a file that is not a controller",
        "`sml verify` and `--controller` take the JSON that `sml synth` writes, from whatever source. The message says\n\
         what is wrong and where. The exit code is 2.\n";
    MalformedStimulus = 105, "a file that is not a stimulus",
        "A stimulus is a CSV. Its header names events of the environment by their texts; each further line is one\n\
         cycle, with a 0 or 1 for each of them. The exit code is 2.\n\n\
         Right:  belt -> controller.blankArrived(),arm -> controller.pickedUp()\n        1,0\n        0,1\n";
    NotExecutable = 106, "an event that cannot happen now",
        "In this state of the play the event is not one of those that can happen: it is not that side's turn, nobody\n\
         asks for it, or it would violate a scenario of its own side. The message lists those that can.\n";
    Stale = 107, "an output that is not up to date",
        "`--check` compares a file with what would be written into it, but for CR at the ends of lines. They differ\n\
         (the notes say where), or the file is missing. Export it again without `--check`. The exit code is 1.\n\n\
         A template of a secondary is stale when the specification no longer has the commands and events that the\n\
         head of the file lists; the notes say which are new and which are gone. It is yours and never overwritten:\n\
         adapt it by hand, then take over the head of a template that is written into another folder. Without\n\
         `--check` this is a warning.\n";
    Unfit = 108, "a controller that a target cannot hold",
        "States, rows or commands outnumber what the target's types can tell apart, or draining would never end. A\n\
         plant that declares no inputs and outputs has no rungs; a closed loop of many states is not drawn. Nothing is\n\
         written.\n";
    FailedExpectation = 109, "an expectation that does not hold",
        "A line of a script for `sml play` says what must hold at this point of the play, and it does not. Lines that\n\
         begin with `-` were expected and are not there, lines with `+` are there and were not expected. The rest of\n\
         the script is played all the same.\n\n\
         expect enabled EVENT; EVENT     all of these can happen next\n\
         expect only EVENT; EVENT        these and nothing else\n\
         expect turn system              or `environment`, or `nobody` once the play is over\n\
         expect lamp.on = true           the value of an attribute\n\
         expect violated SCENARIO        by the last event of the script or an answer to it\n\
         expect active SCENARIO[r=lamp]  some copy with these roles, and perhaps others\n\
         expect not ...                  the opposite of any of these\n";
    MalformedScript = 110, "a line of a script that means nothing",
        "A script for `sml play` has one event text, `yield`, or `expect` and what is expected a line; `#` begins a\n\
         comment. An expectation names scenarios, objects, operations and attributes of the specification: one about\n\
         a name that does not exist would hold or fail for ever, so it is refused before anything is played.\n\n\
         Wrong:  expect enabeld user -> lamp.press()\n\
         Right:  expect enabled user -> lamp.press()\n";
    NotResumable = 111, "a checkpoint that cannot be resumed",
        "The folder of `--spill` holds an exploration of another specification, with other options or by another version\n\
         of the command, or files there are not what was written. Nothing was changed. Name another folder, or remove\n\
         this one to begin anew. The exit code is 2.\n";
    Interrupted = 112, "an exploration that was interrupted",
        "Somebody asked the command to stop, by Ctrl-C or a signal. What was explored so far is in the folder of\n\
         `--spill`; the same command goes on from there. The exit code is 130.\n";

    InitialState = 120, "an automaton without exactly one initial state",
        "Every automaton of a plant, component or constraint, starts in one state, which is written `initial state`. With\n\
         none or two of them nobody could say where the plant is when the controller is switched on.\n\n\
         Wrong:  automaton Door { state Open { shut -> Closed } state Closed { open -> Open } }\n\
         Right:  automaton Door { state Open { shut -> Closed } initial state Closed { open -> Open } }\n";
    Nondeterministic = 121, "an event with two edges in one state",
        "The components of a plant are deterministic: what an event leads to depends on the state alone. If it can end in\n\
         several ways, each of them is an uncontrollable event of its own, which the controller can tell from the others.\n\n\
         Wrong:  automaton Door { initial state Closed { open -> Open open -> Jammed } state Open state Jammed }\n\
         Right:  automaton Door { initial state Closed { open -> Open shut -> Jammed } state Open state Jammed }\n";
    NotWritable = 122, "a command to what the controller cannot write",
        "Events are caused by setting and resetting outputs and memory bits. Inputs and ranges are only read.\n\n\
         Wrong:  controllable stop { reset Closed }\n\
         Right:  controllable stop { reset Motor }\n";
    ContradictoryCommands = 123, "commands of one event that contradict each other",
        "The commands of an event are given in one scan, so one output cannot be set and reset by it.\n\n\
         Wrong:  controllable stop { set Motor reset Motor }\n\
         Right:  controllable stop { reset Motor }\n";
    CommandedByNobody = 124, "commands of an event that happens by itself",
        "The controller does not cause an uncontrollable event, so it gives no commands for it: what it does in answer is a\n\
         controllable event of its own.\n\n\
         Wrong:  uncontrollable jammed { reset Motor }\n\
         Right:  uncontrollable jammed  controllable stop { reset Motor }\n";
    NotBoolean = 125, "an analogue input where a Boolean is due",
        "The formula of a state is about Booleans. An analogue input is divided into ranges, each of which is one: it is\n\
         true while the value lies between both ends. Only an analogue input has ranges.\n\n\
         Wrong:  range Full = Level in 90..=100  automaton Tank { initial state Filled [Level] }\n\
         Right:  range Full = Level in 90..=100  automaton Tank { initial state Filled [Full] }\n";
    NoStates = 126, "a plant or an automaton without states",
        "A plant has at least one component, and an automaton at least one state: without them there is nothing that a\n\
         controller could keep in order.\n\n\
         Wrong:  automaton Door { }\n\
         Right:  automaton Door { initial state Closed }\n";
    CaseOnly = 127, "names that differ by case only",
        "The languages of programmable controllers do not tell `Motor` from `motor`, so two inputs, outputs, memory bits or\n\
         ranges with such names would be one variable. For events, automata and the states of one automaton it is a warning:\n\
         they stand in comments and reports, where people do not tell them apart either.\n\n\
         Wrong:  output Valve, VALVE\n\
         Right:  output Valve1, Valve2\n";
    WrongKind = 128, "a condition about the wrong kind of thing",
        "The formula of a state is about inputs and outputs, by their names: it says how the state is read. A constraint is\n\
         about states, by the names of automaton and state: what inputs and outputs are there is said once, at the state.\n\n\
         Wrong:  constraint Shut: run only when Closed\n\
         Right:  constraint Shut: run only when Door.Shut\n";
    NoCommands = 130, "a controllable event without commands",
        "The controller causes a controllable event by setting and resetting outputs. Without commands there is nothing to\n\
         put on its rung, and the plant would never do it. A plant without any inputs and outputs is not warned about.\n\n\
         Wrong:  controllable run\n\
         Right:  controllable run { set Motor }\n";
    Unreachable = 131, "a state that its automaton never reaches",
        "No sequence of edges leads from the initial state to this one, even if every event could always happen. Often an\n\
         edge is missing or leads to another state than was meant.\n\n\
         Wrong:  automaton Door { initial state Closed state Open { shut -> Closed } }\n\
         Right:  automaton Door { initial state Closed { open -> Open } state Open { shut -> Closed } }\n";
    NeverWritten = 132, "an output or memory bit that no event sets or resets",
        "Formulas read it, but no command changes it, so it has the same value for ever. Perhaps it is an input, or a\n\
         command is missing.\n\n\
         Wrong:  output Lamp  automaton Hall { initial state Dark [!Lamp] }\n\
         Right:  input Lamp  automaton Hall { initial state Dark [!Lamp] }\n";
    NoFormula = 133, "a state that inputs and outputs do not show",
        "A state-feedback controller reads the state of every component from inputs and outputs. In a component with\n\
         several states each of them therefore needs a formula in brackets. A controller that follows events needs none.\n\n\
         Wrong:  automaton Door { initial state Shut [Closed] { open -> Ajar } state Ajar { shut -> Shut } }\n\
         Right:  automaton Door { initial state Shut [Closed] { open -> Ajar } state Ajar [!Closed] { shut -> Shut } }\n";
    NeverHolds = 134, "a formula that never holds",
        "No values of inputs and outputs make the formula of this state true, so the state would never be recognised.\n\
         Ranges of one analogue input count with their limits: no value lies in two that do not overlap.\n\n\
         Wrong:  automaton Door { initial state Shut [Closed && !Closed] }\n\
         Right:  automaton Door { initial state Shut [Closed] }\n";
    Overlap = 135, "two states that look the same",
        "Some values of inputs and outputs make the formulas of two states of one component true, so nobody could say in\n\
         which of them it is. The values are shown. Add what tells the two apart: mostly the output that was set when the\n\
         component began to move.\n\n\
         Wrong:  automaton Door { initial state Shut [Closed] { run -> Moves } state Moves [Motor] { stop -> Shut } }\n\
         Right:  automaton Door { initial state Shut [!Motor] { run -> Moves } state Moves [Motor] { stop -> Shut } }\n";
    Contradicted = 136, "a command after which the target of the event is never read",
        "What an event commands is read from then on, so the formula of the state to which it leads has to be possible\n\
         with it. Mostly `set` and `reset` were confused, or a `!` is missing.\n\n\
         Wrong:  controllable go { set Motor }\n        \
         automaton Door { initial state Rests [Closed] { go -> Moves } state Moves [!Closed && !Motor] }\n\
         Right:  controllable go { set Motor }\n        \
         automaton Door { initial state Rests [Closed && !Motor] { go -> Moves } state Moves [Motor] }\n";
    Misread = 137, "a command after which the wrong state is read",
        "An event of the controller has happened as soon as its commands are given. From then on, the state that is read\n\
         must be its target: the rungs below it and the next scan decide by what they read, long before a sensor answers.\n\
         Here it can still be the old state, or is another one; so a second event may happen that must not happen in the\n\
         target, even one that a `never` forbids there.\n\n\
         Name the outputs that are commanded: the formula of the old state excludes them, that of the target holds as soon\n\
         as they are given. Where a part answers later, give it two states: told to move, and arrived.\n\n\
         Wrong:  controllable go { set Motor }\n        \
         automaton Door { initial state Shut [Closed] { go -> Open } state Open [!Closed] }\n\
         Right:  controllable go { set Motor }\n        \
         automaton Door { initial state Shut [Closed && !Motor] { go -> Open } state Open [Motor] }\n";
    Misreadable = 138, "a command after which the wrong state could be read",
        "Right after an event of the controller its target is read, or what the plant can come to from there by itself: so\n\
         it should be for all values that the formula of the old state allows. Here some of them show another state, or\n\
         none shows the target until the plant has moved. Perhaps these values never occur, such as two end\n\
         switches that are closed at one time: then say so in the formula of the old state.\n\n\
         A component that does not take part in an event, but reads what it commands, must not change its state either,\n\
         except to one that it can come to by itself.\n\n\
         Wrong:  controllable go { set Motor }\n        \
         automaton Door { initial state Shut [Closed && !Motor] { go -> Open } state Open [!Closed && Motor] }\n\
         Right:  controllable go { set Motor }\n        \
         automaton Door { initial state Shut [Closed && !Motor] { go -> Open } state Open [Motor] }\n";
    Unnoticed = 139, "an event that happens by itself and is never seen",
        "An uncontrollable event changes inputs, and never outputs: these keep what the program has commanded. Here, the two\n\
         states that the event leads from and to differ in outputs only, so that the controller would read the old state for\n\
         ever. Say in both formulas what a sensor shows; or if a command ends the state, make the event controllable.\n\n\
         Wrong:  controllable go { set Motor }  uncontrollable done\n        \
         automaton Door { initial state Rests [!Motor] { go -> Moves } state Moves [Motor] { done -> Rests } }\n\
         Right:  controllable go { set Motor }  controllable done { reset Motor }\n        \
         automaton Door { initial state Rests [!Motor] { go -> Moves } state Moves [Motor] { done -> Rests } }\n";
    NoFeedback = 140, "constraints that no feedback can keep",
        "The feedback may inhibit controllable events only, and must leave a way to a state in which all automata are\n\
         marked. From the initial state of this plant, whatever is inhibited, either a constraint is violated (a `never`\n\
         holds, or something forbids an uncontrollable event that the components allow), or no such way is left. The play\n\
         shows how: its last events happen by themselves, and nobody can prevent them.\n\n\
         Weaken the constraint, mark more states, or make an event of the play controllable: often an actuator can\n\
         stop what a constraint does not want.\n\n\
         Wrong:  plant P { uncontrollable rise  constraint Dry: never Tank.Over\n        \
         automaton Tank { initial state Low { rise -> Over } state Over } }\n\
         Right:  plant P { controllable rise  constraint Dry: never Tank.Over\n        \
         automaton Tank { initial state Low { rise -> Over } state Over } }\n";
    AutomatonTooLarge = 141, "an automaton with more states than can be numbered",
        "States of one automaton are numbered by 16 bits, so there can be 65,536. A component of that size is rarely one\n\
         component: write its parts as automata of their own, with the events in which they act together in each of them.\n";
    Unseen = 142, "what nobody can see makes a difference",
        "The feedback depends on something that inputs, outputs and memory do not show. Either two states of the plant look\n\
         the same, though an event may happen in only one of them; or a constraint automaton follows events that look\n\
         the same: a controller sees no events, it sees the states of components before and afterwards. Bits of memory\n\
         are added where they suffice; here they do not.\n\n\
         Show the difference in the formulas of states, add a sensor or a component that has it, or let the controller\n\
         follow events instead of states.\n";
    FormulaTooLarge = 143, "a formula that is too large",
        "Formulas are computed as decision diagrams, and one of these would exceed what a machine holds. This happens if\n\
         the event depends on the states of very many components at once, in no order.\n\n\
         Split the plant into parts that are controlled apart, or let the controller follow events instead of states.\n";
    NeverEnabled = 144, "a controllable event that is never enabled",
        "The feedback enables this event nowhere, so the controller never gives its commands: either the plant never comes\n\
         where its components allow it, or it is inhibited wherever they do. The notes say how often, and by what. Mostly a\n\
         constraint says more than was meant, or names a state in which the event is not possible anyway.\n\n\
         Wrong:  controllable open { set Motor }  constraint Safe: open only when Door.Ajar\n        \
         automaton Door { initial state Shut [!Motor] { open -> Ajar } state Ajar [Motor] }\n\
         Right:  controllable open { set Motor }  constraint Safe: open only when Door.Shut\n        \
         automaton Door { initial state Shut [!Motor] { open -> Ajar } state Ajar [Motor] }\n";
    Race = 145, "events that one scan cannot tell apart",
        "A controller that follows events sees which ones have come since its last scan, not in which order. If these\n\
         come in the order shown, all within one scan, it takes them for something else, or one of them fits nowhere any\n\
         more: from then on it is wrong about the plant. If the last of them is a command, the event in front of it came\n\
         too late to be seen when the command was given, and is not possible behind it.\n\n\
         Make sure that these events cannot come within one scan: let scans be shorter than the plant takes for them. Or\n\
         tell the plant better: allow both orders, with the same state behind them, or put a state between the events\n\
         that lasts. If neither will do, let the controller read states instead of following events.\n";
    Conflict = 146, "modules that conflict",
        "Every constraint has a supervisor of its own that keeps a way to its marked states. All of them together do not:\n\
         the automata can come into the states shown, and no way leads from there to a state in which all are marked. Two\n\
         users who take the same two tools in different order are an example.\n\n\
         The plant as a whole may have a feedback all the same: supervise it without `--modular`. If it is too large for\n\
         that, write the constraints that block each other as one constraint automaton, or add one that keeps them apart.\n";
    ConflictUnknown = 147, "modules that may conflict",
        "Whether supervisors of single constraints block each other shows only in their product, and that is too large.\n\
         What they forbid is right: no constraint is violated. But a state could be reached from which no state leads on\n\
         in which all automata are marked.\n\n\
         Raise `--max-states`, or mark only where somebody really has to come back: where all states are marked, nothing\n\
         can conflict.\n";
    Circle = 148, "commands that undo each other without end",
        "These events of the controller lead back to where they began, and nothing of the plant is waited for in\n\
         between. The feedback permits all of them, so the program gives them again and again, perhaps all of them within\n\
         one scan.\n\n\
         A feedback forbids no more than it must: say when the one is wanted and when the other. Mostly a state between\n\
         them waits for a sensor or a button, or a constraint says after which event of the plant the command may be\n\
         given.\n\n\
         Wrong:  controllable go { set Motor }  controllable halt { reset Motor }\n        \
         automaton Door { initial state Rests [!Motor] { go -> Moves } state Moves [Motor] { halt -> Rests } }\n\
         Right:  controllable go { set Motor }  controllable halt { reset Motor }\n        \
         uncontrollable shut  uncontrollable open  automaton Door {\n        \
         initial state Ajar [!Closed && !Motor] { go -> Moves } state Moves [!Closed && Motor] { shut -> Done }\n        \
         state Done [Closed && Motor] { halt -> Shut } state Shut [Closed && !Motor] { open -> Ajar } }\n";
    NeverGiven = 149, "a command that a controller never gives",
        "A controller that follows events decides for one command at most, where the feedback permits several. It takes the\n\
         one after which the fewest commands follow until the plant has the turn; where it may as well wait, it waits.\n\
         This event is possible somewhere, and never chosen; or the controller never comes to where it is possible.\n\n\
         Say by a constraint when the other command has to wait, or let an event of the plant, say a button, ask for\n\
         this one.\n";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_is_explained() {
        for pair in Code::ALL.windows(2) {
            assert!((pair[0] as u16) < pair[1] as u16, "{} is out of order", pair[1]);
        }
        for code in Code::ALL {
            assert!(!code.title().ends_with('.'), "{code}");
            assert!(code.explanation().ends_with('\n'), "{code}");
            assert!(code.explanation().len() > 100, "{code}");
            for line in code.explanation().lines() {
                assert!(line.chars().count() <= 115 && line == line.trim_end(), "{code}: {line}");
            }
        }
    }

    #[test]
    fn codes_are_found_however_they_are_written() {
        for text in ["SML0007", "sml7", "7", "0007", "Sml007"] {
            assert_eq!(Code::from_text(text), Some(Code::NumberForm), "{text}");
        }
        for text in ["", "SML", "SML9999", "E0007", "7x", "-7", "99999999999999999999", "é7", "SML 7"] {
            assert_eq!(Code::from_text(text), None, "{text}");
        }
    }

    #[test]
    fn codes_have_four_digits() {
        assert_eq!(Code::Lexical.to_string(), "SML0001");
    }
}
