//! Everything that the language reference says must be refused, with its place, before and during play-out.

use super::*;
use crate::syntax::tests::unmark;
use crate::testing::loaded;

/// What is wrong with the text before or during play-out.
fn found(text: &str) -> Vec<Diagnostic> {
    let loaded = loaded(text);
    let run =
        || play_and_solve(&specification(&loaded)?, &Options::default(), &mut Timings::default()).map(drop);
    run().err().map(|failure| failure.diagnostics()).unwrap_or_default()
}

/// The diagnostics of the text are exactly its marks, each `~~~~ CODE message` under the place.
#[track_caller]
fn check(marked: &str) -> Vec<Diagnostic> {
    let (text, marks) = unmark(marked);
    let found = found(&text);
    let shown: Vec<_> = found.iter().map(|d| (d.span, format!("{} {}", d.code as u16, d.message))).collect();
    assert_eq!(shown, marks, "{text}\n{found:#?}");
    found
}

/// Classes, objects and sections that the scenarios of these tests speak of.
const WORLD: &str = "specification X {
  domain d {
    enum Color { red, green }
    enum Fruit { red, apple }
    abstract class Thing { weight: 0..=3 }
    class Lamp : Thing { lit: bool  color: Color  next: Lamp  level: 0..=3  on()  dim(to: 0..=3)  paint(with: Color) }
    class Control { count: 0..=3  press()  level(to: 0..=9)  look(at: Lamp) }
    class User { }
  }
  object control: Control
  object lamp: Lamp
  object other: Lamp
  object user: User
  controllable { Control }
";

/// As [`check`] for sections behind those of the world.
#[track_caller]
fn check_section(marked: &str) -> Vec<Diagnostic> {
    check(&format!("{WORLD}{marked}\n}}"))
}

/// As [`check`] for what stands in a collaboration.
#[track_caller]
fn check_item(marked: &str) -> Vec<Diagnostic> {
    check_section(&format!("collaboration C {{\n{marked}\n}}"))
}

/// As [`check`] for the body of a guarantee that a user starts; `some` is a dynamic role.
#[track_caller]
fn check_body(marked: &str) -> Vec<Diagnostic> {
    check_item(&format!(
        "dynamic role Lamp some\nguarantee scenario G {{\nuser -> control.press()\n{marked}\n}}"
    ))
}

/// As [`check`] for sections in front of everything else: a small world of its own.
#[track_caller]
fn check_domain(marked: &str) -> Vec<Diagnostic> {
    check(&format!(
        "specification X {{\n{marked}\nobject control: Control\ncontrollable {{ Control }}\ndomain {{ class Control {{ count: 0..=3 }} }} }}"
    ))
}

#[test]
fn unknown_names() {
    check_section("object x: Lmap\n          ~~~~ 20 unknown class `Lmap`");
    check_section(
        "object x: Lamp { lti: true }\n                 ~~~ 20 unknown attribute of class `Lamp`: `lti`",
    );
    check_section("object x: Lamp { color: blue }\n                        ~~~~ 20 unknown name `blue`");
    check_section("domain { class A { a: Colour } }\n                      ~~~~~~ 20 unknown type `Colour`");
    check_section("domain { class A : Thng { } }\n                   ~~~~ 20 unknown class `Thng`");
    check_section("controllable { Contol }\n               ~~~~~~ 20 unknown class `Contol`");
    check_section(
        "non-spontaneous events { Control.pres }\n                                 ~~~~ 20 unknown operation of class `Control`: `pres`",
    );
    check_section(
        "parameter ranges { Control.level(t = [1]) }\n                                 ~ 20 unknown parameter of `level`: `t`",
    );
    check_section(
        "channels { Control.press over User.ref }\n                                   ~~~ 20 unknown attribute of class `User`: `ref`",
    );
    check_section("effects { usr -> control.press() { } }\n          ~~~ 20 unknown object or class `usr`");
    check_section(
        "effects { user -> control.press() { receiver.cont = 1 } }\n                                             ~~~~ 20 unknown attribute of class `Control`: `cont`",
    );
    check_item("static role Lamp lmap\n                 ~~~~ 20 unknown object `lmap`");
    check_body("urgent control -> lampp.on()\n                  ~~~~~ 20 unknown role or object `lampp`");
    check_body(
        "urgent control -> lamp.onn()\n                       ~~~ 20 unknown operation of class `Lamp`: `onn`",
    );
    check_body("wait [lamp.lti]\n           ~~~ 20 unknown attribute of class `Lamp`: `lti`");
    check_body("wait [lamp.color == blue]\n                    ~~~~ 20 unknown name `blue`");
    check_body(
        "wait [lamp.color == Color:blue]\n                          ~~~~ 20 unknown literal of enum `Color`: `blue`",
    );
    check_body("wait [lamp.color == Colr:red]\n                    ~~~~ 20 unknown enum `Colr`");
    check_body("x = 3\n~ 20 unknown variable `x`");
    check_body("lamp -> control.look(bind x)\n                          ~ 20 unknown variable `x`");
    check_item(
        "guarantee scenario G bindings [some = lamp] { user -> control.press() }\n                               ~~~~ 20 unknown dynamic role `some`",
    );
}

#[test]
fn help_for_unknown_names() {
    let help = |found: Vec<Diagnostic>| found[0].help.clone().expect("help");
    assert_eq!(
        help(check_body("var int x\n    ~~~ 20 unknown type `int`")),
        "write a range of integers such as `0..=9`"
    );
    assert_eq!(help(check_body("var boolean x\n    ~~~~~~~ 20 unknown type `boolean`")), "write `bool`");
    assert_eq!(
        help(check_body("var String x\n    ~~~~~~ 20 unknown type `String`")),
        "declare an `enum` with the texts that can occur"
    );
    assert_eq!(help(check_body("wait [True]\n      ~~~~ 20 unknown name `True`")), "write `true`");
    assert_eq!(
        help(check_body("wait [lamp.next == None]\n                   ~~~~ 20 unknown name `None`")),
        "write `null`"
    );
    assert_eq!(
        help(check_body("wait [lapm.lit]\n      ~~~~ 20 unknown name `lapm`")),
        "write `lamp`, which is declared"
    );
}

#[test]
fn duplicate_names_at_the_second() {
    check_section("object lamp: Lamp\n       ~~~~ 21 object `lamp` is declared a second time");
    check_section("domain { class Lamp { } }\n               ~~~~ 21 class `Lamp` is declared a second time");
    check_section("domain { enum Lamp { a } }\n              ~~~~ 21 enum `Lamp` is declared a second time");
    check_section("object Color: Lamp\n       ~~~~~ 21 object `Color` is declared a second time");
    check_section(
        "domain { enum E { a, b, a } }\n                        ~ 21 literal `a` is declared a second time",
    );
    check_section(
        "domain { class A { a: bool a: bool } }\n                           ~ 21 attribute `a` is declared a second time",
    );
    check_section(
        "domain { class A { a() a() } }\n                       ~ 21 operation `a` is declared a second time",
    );
    check_section(
        "domain { class A : Thing { weight: bool } }\n                           ~~~~~~ 21 attribute `weight` is inherited already",
    );
    check_section(
        "domain { class A { a: bool setA(a: bool) } }\n                           ~~~~ 21 operation `setA` is declared a second time",
    );
    check_section(
        "domain { class A { a(x: bool, x: bool) } }\n                              ~ 21 parameter `x` is declared a second time",
    );
    check_section(
        "object x: Lamp { lit: true lit: false }\n                           ~~~ 21 value of `lit` is declared a second time",
    );
    check_section(
        "effects { lamp -> control.level(a, a) { } }\n                          ~~~~~ 23 `level` takes 1 argument, but 2 are given",
    );
    check_item("dynamic role Lamp lamp\n                  ~~~~ 21 role `lamp` is declared a second time");
    check_item(
        "dynamic role Lamp a\ndynamic role Lamp a\n                  ~ 21 role `a` is declared a second time",
    );
    check_item(
        "guarantee scenario G { user -> control.press() }\nguarantee scenario G { user -> control.press() }\n                   ~ 21 scenario `G` is declared a second time",
    );
    check_body(
        "var bool x = true var bool x = true\n                           ~ 21 variable `x` is declared a second time",
    );
}

#[test]
fn the_first_declaration_is_shown() {
    let found = check_section("object lamp: Lamp\n       ~~~~ 21 object `lamp` is declared a second time");
    let [(first, text)] = found[0].labels.as_slice() else { panic!("{found:?}") };
    assert_eq!((first.start.line, text.as_str()), (11, "first declared here"));
}

#[test]
fn wrong_types() {
    check_section("object x: Lamp { lit: 1 }\n                      ~ 22 expected `bool`, found an integer");
    check_section(
        "object x: Lamp { color: true }\n                        ~~~~ 22 expected a literal of `Color`, found `bool`",
    );
    check_section(
        "object x: Lamp { next: user }\n                       ~~~~ 22 expected an object of `Lamp`, found an object of `User`",
    );
    check_section("object x: Thing\n          ~~~~~ 22 class `Thing` is abstract and has no objects");
    check_section(
        "channels { Control.press over Lamp.lit }\n                                   ~~~ 22 `lit` is no reference to an object",
    );
    check_section(
        "effects { user -> control.press() { count = 1 } }\n                                    ~~~~~ 22 an effect assigns an attribute of an object",
    );
    check_section(
        "effects { user -> control.press() { receiver.count = true } }\n                                                     ~~~~ 22 expected an integer, found `bool`",
    );
    check_item("static role User lamp\n            ~~~~ 22 object `lamp` is no `User`");
    check_body("wait [lamp]\n      ~~~~ 22 expected `bool`, found an object of `Lamp`");
    check_body("wait [lamp.lit + 1 > 0]\n      ~~~~~~~~ 22 expected an integer, found `bool`");
    check_body(
        "wait [lamp.lit < true]\n      ~~~~~~~~ 22 expected an integer, found `bool`\n                 ~~~~ 22 expected an integer, found `bool`",
    );
    check_body(
        "wait [lamp == user]\n              ~~~~ 22 expected an object of `Lamp`, found an object of `User`",
    );
    check_body("wait [lamp.lit.on]\n               ~~ 22 `bool` has no attributes");
    check_body("wait [red == red]\n             ~~~ 22 `red` is a literal of several enums");
    check_body(
        "urgent control -> lamp.dim(true)\n                           ~~~~ 22 expected an integer, found `bool`",
    );
    check_body("var bool x = 1\n             ~ 22 expected `bool`, found an integer");
    check_body(
        "var bool x lamp -> control.level(bind x)\n                                      ~ 22 variable `x` is of type `bool`, not `0..=9`",
    );
    check_item(
        "dynamic role Lamp a\nguarantee scenario G bindings [a = user] { user -> control.press() }\n                                   ~~~~ 22 expected an object of `Lamp`, found an object of `User`",
    );
}

#[test]
fn wrong_argument_counts() {
    check_body(
        "urgent control -> lamp.dim()\n                       ~~~ 23 `dim` takes 1 argument, but 0 are given",
    );
    check_body(
        "urgent control -> lamp.on(1)\n                       ~~ 23 `on` takes 0 arguments, but 1 is given",
    );
    check_body(
        "urgent control -> lamp.dim\n                       ~~~ 23 `dim` takes 1 argument, but 0 are given",
    );
}

#[test]
fn read_before_bound() {
    check_body("var bool x wait [x]\n                 ~ 24 variable `x` is read before it is bound");
    check_body("wait [some.lit]\n      ~~~~ 24 dynamic role `some` is read before it is bound");
    check_body(
        "var bool x\nalternative [lamp.lit] { x = true }\nwait [x]\n      ~ 24 variable `x` is read before it is bound",
    );
    check_body(
        "var bool x\nwhile [lamp.lit] { some -> control.press() x = true }\nwait [x]\n      ~ 24 variable `x` is read before it is bound",
    );
    check_body(
        "parallel { var bool x = some.lit } and { some -> control.press() }\n                        ~~~~ 24 dynamic role `some` is read before it is bound",
    );
}

#[test]
fn unbound_roles() {
    check_body(
        "urgent control -> some.on()\n                  ~~~~ 25 the system must send this, but role `some` is not bound yet",
    );
    for good in [
        "monitored urgent control -> some.on()",
        "control -> some.on()",
        "some -> control.press() urgent control -> some.on()",
    ] {
        check_body(good);
    }
}

#[test]
fn no_controllable_class() {
    check(
        "specification X { }\n              ~ 26 no class is controllable, so there is no controller to build",
    );
    check(
        "specification X { controllable { } }\n                  ~~~~~~~~~~~~ 26 no class is controllable, so there is no controller to build",
    );
}

#[test]
fn empty_scenarios() {
    check_item("guarantee scenario G { }\n                   ~ 27 scenario `G` is empty");
    check_item(
        "existential scenario G { } constraints [ forbidden user -> control.press() ]\n                     ~ 27 scenario `G` is empty",
    );
}

#[test]
fn constants_out_of_range() {
    check_section(
        "object x: Lamp { level: 4 }\n                        ~ 28 `4` is not in the range `0..=3`",
    );
    check_section(
        "domain { class A { a: 0..=3 = 4 } }\n                              ~ 28 `4` is not in the range `0..=3`",
    );
    check_section(
        "domain { class A { a: 3..=0 } }\n                      ~~~~~ 28 the range `3..=0` contains no value",
    );
    check_section(
        "domain { class A { a: 0..=4294967296 } }\n                      ~~~~~~~~~~~~~~ 28 the range `0..=4294967296` has more than 2^32 values",
    );
    check_section(
        "parameter ranges { Control.level(to = [10]) }\n                                       ~~ 28 `10` is not in the range `0..=9`",
    );
    check_section(
        "parameter ranges { Control.level(to = [3..1]) }\n                                       ~ 28 the span from `3` to `1` is empty",
    );
    check_section(
        "effects { user -> control.press() { receiver.count = 4 } }\n                                                     ~ 28 `4` is not in the range `0..=3`",
    );
    check_body(
        "urgent control -> lamp.dim(-1)\n                           ~~ 28 `-1` is not in the range `0..=3`",
    );
    check_body("var 0..=3 x = 4\n              ~ 28 `4` is not in the range `0..=3`");
}

#[test]
fn silent_loops() {
    check_body("while { }\n~~~~~~~~~ 29 this loop can come round without a message or `wait`");
    check_body(
        "while [lamp.lit] { alternative [lamp.lit] { user -> control.press() } }\n~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ 29 this loop can come round without a message or `wait`",
    );
    check_body(
        "while { while [lamp.lit] { wait [lamp.lit] } }\n~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ 29 this loop can come round without a message or `wait`",
    );
}

#[test]
fn cyclic_inheritance() {
    check_section(
        "domain { class A : B { } class B : A { } }\n                                   ~ 30 class `B` inherits from itself",
    );
    check_section("domain { class A : A { } }\n                   ~ 30 class `A` inherits from itself");
}

#[test]
fn assumptions_that_oblige_the_system() {
    check_item(
        "assumption scenario A { user -> control.press() urgent control -> lamp.on() }\n                                                       ~~~~~~~~~~~~~~~~~~~~ 31 an assumption cannot oblige the system: the sender of this message is controllable",
    );
    check_item(
        "assumption scenario A { user -> control.press() monitored urgent control -> lamp.on() }\n                                                                 ~~~~~~~~~~~~~~~~~~~~ 31 an assumption cannot oblige the system: the sender of this message is controllable",
    );
}

/// One mistake, one error: what follows from it is not told.
#[test]
fn one_cause_one_error() {
    check_domain(
        "domain { class Lapm { } class A : Lamp { } }
                                  ~~~~ 20 unknown class `Lamp`
object a: A
collaboration C {
  static role Lamp a
  guarantee scenario G { a -> control.setCount(1) urgent control -> a.setX(1) wait [a.x == 1] }
}",
    );
    check_domain(
        "domain { class L { c: Colour } }
                      ~~~~~~ 20 unknown type `Colour`
object l: L { c: red }
collaboration C { guarantee scenario G { control -> l.setC(red) wait [l.c == red] } }",
    );
    check_item(
        "dynamic role Lmap a
             ~~~~ 20 unknown class `Lmap`
guarantee scenario G bindings [a = lamp] { user -> control.press() urgent control -> a.on() wait [a.lit] }",
    );
    check_body(
        "var 0..=3 x = lmap.level
              ~~~~ 20 unknown name `lmap`
lmap -> control.press()
urgent control -> lmap.on()
wait [x == 3]",
    );
    check_body(
        "some -> control.prss()
                ~~~~ 20 unknown operation of class `Control`: `prss`
urgent control -> some.on()",
    );
    check_section(
        "effects { user -> control.press() { receiver.cnt = 1 } }
                                             ~~~ 20 unknown attribute of class `Control`: `cnt`
collaboration C { guarantee scenario G { user -> control.press() wait [control.cnt == 1] urgent control -> control.setCnt(1) } }",
    );
}

/// As [`check_body`]; the mistake shows at the end of the shortest play that leads there.
#[track_caller]
fn check_play(marked: &str, play: &[&str]) {
    let found = check(&format!("{WORLD}{marked}\n}}"));
    let shown: Vec<&str> =
        found[0].notes.iter().flat_map(|note| note.lines().skip(1)).map(str::trim).collect();
    assert_eq!(shown, play, "{found:#?}");
    assert!(found[0].help.is_some(), "{found:#?}");
}

#[test]
fn an_attribute_leaves_its_range() {
    check_play(
        "effects { user -> control.press() { receiver.count = receiver.count + 2 } }
                                    ~~~~~~~~~~~~~~ 50 `control.count` would become `4`, which is not in `0..=3`
collaboration C { guarantee scenario G { user -> control.press() urgent control -> lamp.on() } }",
        &["user -> control.press()", "control -> lamp.on()", "user -> control.press()"],
    );
}

#[test]
fn an_attribute_leaves_its_range_through_its_setter() {
    check_play(
        "collaboration C { guarantee scenario G { user -> control.press() urgent control -> lamp.setLevel(lamp.level + 2) } }
                                                                        ~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~ 50 argument `level` would be `4`, which is not in `0..=3`",
        &["user -> control.press()", "control -> lamp.setLevel(2)", "user -> control.press()"],
    );
}

#[test]
fn a_variable_leaves_its_range() {
    check_play(
        "collaboration C { guarantee scenario G {
  user -> control.press()
  var 0..=3 x = 0
  while { user -> control.press() x = x + 3 }
                                  ~~~~~~~~~ 50 variable `x` would become `6`, which is not in `0..=3`
} }",
        &["user -> control.press()", "user -> control.press()", "user -> control.press()"],
    );
}

#[test]
fn a_path_through_null() {
    check_play(
        "collaboration C { guarantee scenario G { user -> control.press() wait [lamp.next.lit] } }
                                                                       ~~~~~~~~~~~~~ 51 this path leads through `null`",
        &["user -> control.press()"],
    );
}

#[test]
fn a_loop_that_never_settles() {
    check_play(
        "collaboration C { guarantee scenario G { user -> control.press() while { wait [!lamp.lit] } } }
                                                                         ~~~~~~~~~~~~~~~~ 52 this loop never settles",
        &["user -> control.press()"],
    );
}

#[test]
fn a_scenario_that_is_violated_already() {
    check_play(
        "collaboration C { guarantee scenario G { violation [true] } }
                                     ~ 53 scenario `C.G` is violated in the initial state",
        &[],
    );
}

/// A mistake counts only where the event can really happen.
#[track_caller]
fn check_unreached(scenarios: &str) {
    let increments = "effects { user -> control.press() { receiver.count = receiver.count + 1 } }";
    check_section(&format!("{increments} collaboration C {{ {scenarios} }}"));
}

#[test]
fn an_event_that_violates_an_assumption_makes_no_mistake() {
    check_unreached(
        "guarantee scenario G { user -> control.press() }
         assumption scenario Once { user -> control.press() wait [lamp.lit] }
           constraints [ forbidden user -> control.press() ]",
    );
}

#[test]
fn an_event_in_the_turn_of_others_makes_no_mistake() {
    check_unreached(
        "guarantee scenario G { user -> control.press() }
         guarantee scenario Busy { wait [control.count == 3] while { urgent control -> lamp.on() } }",
    );
}

#[test]
fn an_event_that_nothing_causes_makes_no_mistake() {
    check_section(
        "effects { user -> control.press() { receiver.count = receiver.count + 1 } }
         non-spontaneous events { Control.press }
         collaboration C { guarantee scenario G { user -> control.press() } }",
    );
}

/// The codes and lines of all mistakes, in their order.
#[track_caller]
fn check_all(text: &str, expect: &[(u16, u32)]) {
    let shown: Vec<(u16, u32)> = found(text).iter().map(|d| (d.code as u16, d.span.start.line)).collect();
    assert_eq!(shown, expect, "{text}");
}

#[test]
fn names_are_looked_up_where_only_scenarios_and_effects_cannot_be_read() {
    let collaboration = |scenarios: &str| {
        format!(
            "{}collaboration C {{\n{scenarios}\n}} }}",
            WORLD.replace("object other: Lamp", "object other: Lmap")
        )
    };
    let wrong_name = "guarantee scenario A { user -> control.pres() }\n";
    check_all(
        &collaboration(&format!("{wrong_name}guarantee scenario B {{ user -> control.press() wait lamp }}")),
        &[(20, 12), (20, 16), (4, 17)],
    );
    check_all(
        &collaboration(&format!("guarantee scenario B {{ € }}\n{wrong_name}")),
        &[(20, 12), (1, 16), (20, 17)],
    );
    check_all(&collaboration("guarantee scenario B { user -> control.press( } "), &[(2, 16)]);
    check_all(
        &collaboration(&format!("gaurantee scenario B {{ }}\n{wrong_name}")),
        &[(20, 12), (4, 16), (20, 17)],
    );
    check_all(
        &collaboration(&format!("guarantee scenario B {{ wait [1 < 2 < 3] wait lamp }}\n{wrong_name}")),
        &[(20, 12), (13, 16), (20, 17)],
    );
    // What a role, a class or an object is called is not known then.
    check_all(&collaboration(&format!("dynmic role Lamp some\n{wrong_name}")), &[(4, 16)]);
    check_all(&collaboration(&format!("guarantee B {{ }}\n{wrong_name}")), &[(4, 16)]);
    check_all(
        &format!("{WORLD}effects {{\nuser control.press() {{ }} }}\nobject x: Lmap }}"),
        &[(4, 16), (20, 17)],
    );
    check_all(&format!("{WORLD}channels {{ x }}\nobject x: Lmap }}"), &[(4, 15), (20, 16)]);
    check_all(&format!("{WORLD}object y Lamp\nobject x: Lmap }}"), &[(4, 15)]);
}

#[test]
fn help_for_wrong_types_and_counts() {
    let help = |found: Vec<Diagnostic>| found[0].help.clone().expect("help");
    assert_eq!(
        help(check_body(
            "wait [lamp.color == 3]\n                    ~ 22 expected a literal of `Color`, found an integer"
        )),
        "write a literal of `Color` here, or change the declaration"
    );
    assert_eq!(
        help(check_body("wait [lamp.level]\n      ~~~~~~~~~~ 22 expected `bool`, found an integer")),
        "write a truth value here, or change the declaration"
    );
    assert_eq!(
        help(check_body(
            "urgent control -> lamp.on(1)\n                       ~~ 23 `on` takes 0 arguments, but 1 is given"
        )),
        "write `on()`"
    );
    assert_eq!(
        help(check_section(
            "domain { class A { a: bool setA(a: bool) } }\n                           ~~~~ 21 operation `setA` is declared a second time"
        )),
        "remove it: the setter of an attribute exists without being declared"
    );
}

/// The help for a mistake in the syntax of sections behind those of the world.
#[track_caller]
fn check_help(sections: &str, expect: &str) {
    let found = found(&format!("{WORLD}{sections}\n}}"));
    assert_eq!(found[0].help.as_deref(), Some(expect), "{found:#?}");
}

#[track_caller]
fn check_help_in_body(fragments: &str, expect: &str) {
    check_help(
        &format!("collaboration C {{ guarantee scenario G {{ user -> control.press() {fragments} }} }}"),
        expect,
    );
}

#[test]
fn help_for_habits() {
    check_help_in_body("alternative { } and { }", "write `or`, or put a `parallel` in front");
    check_help_in_body("parallel { } or { }", "write `and`, or put an `alternative` in front");
    check_help_in_body("alternative if [lamp.lit] { }", "remove `if`");
    check_help_in_body("for [lamp.lit] { }", "write `while`");
    check_help_in_body("eventually wait [lamp.lit]", "write `wait eventually [ … ]`");
    check_help_in_body("strict eventually wait [lamp.lit]", "write `wait strict eventually [ … ]`");
    check_help_in_body("strict wait [lamp.lit]", "write `wait strict [ … ]`");
    check_help_in_body("lamp.lit = true", "put the assignment into the section `effects`");
    check_help_in_body("} constraints { forbidden control -> lamp.on()", "write `[ … ]` instead of `{ … }`");
    check_help("collaboration C { guarantee G { } }", "write `guarantee scenario`");
    check_help("domain { class A extends Lamp { } }", "write `:` and the class to inherit from");
    check_help("non-spontaneous events { Control.press() }", "remove the parentheses");
    check_help("parameter ranges { Control.level(to = 1..3) }", "put the range into brackets: `[ … ]`");
}
