//! What the author meant, said as an edit: slips of the keyboard, and habits from other languages.

use super::{parse, unmark};

/// The marks of the text are its diagnostics, each `~~~~ help` under the place.
#[track_caller]
fn check(marked: &str) {
    let (text, marks) = unmark(marked);
    let (_, errors) = parse(&text);
    let found: Vec<_> = errors.iter().map(|d| (d.span, d.help.clone().unwrap_or_default())).collect();
    assert_eq!(found, marks, "{text}\n{errors:#?}");
}

/// As [`check`] for the body of a scenario.
#[track_caller]
fn check_body(marked: &str) {
    check(&format!("specification X {{ collaboration C {{ guarantee scenario S {{\n{marked}\n}} }} }}"));
}

/// As [`check`] for what stands in a collaboration.
#[track_caller]
fn check_item(marked: &str) {
    check(&format!("specification X {{ collaboration C {{\n{marked}\n}} }}"));
}

/// As [`check`] for a section.
#[track_caller]
fn check_section(marked: &str) {
    check(&format!("specification X {{\n{marked}\n}}"));
}

/// As [`check`] for the members of a class.
#[track_caller]
fn check_class(marked: &str) {
    check(&format!("specification X {{ domain {{ class A {{\n{marked}\n}} }} }}"));
}

#[test]
fn misspelt_header() {
    check("specificaton X { }\n~~~~~~~~~~~~ write `specification`");
    check("Specification X { }\n~~~~~~~~~~~~~ write `specification`");
    check("system specificaton X { }\n       ~~~~~~~~~~~~ write `specification`");
    check("improt \"a.sml\" specification X { }\n~~~~~~ write `import`");
    check("program X { }\n~~~~~~~ begin with `specification Name { … }`");
}

#[test]
fn misspelt_sections() {
    check_section("domains { }\n~~~~~~~ write `domain`");
    check_section("objct a: A\n~~~~~ write `object`");
    check_section("effect { }\n~~~~~~ write `effects`");
    check_section("controlable { A }\n~~~~~~~~~~~ write `controllable`");
    check_section("channel { }\n~~~~~~~ write `channels`");
    check_section("parameters ranges { }\n~~~~~~~~~~ write `parameter`");
    check_section("parameter range { }\n          ~~~~~ write `ranges`");
    check_section("colaboration C { }\n~~~~~~~~~~~~ write `collaboration`");
    check_section("import \"a.sml\"\n~~~~~~ move it in front of `specification`");
}

#[test]
fn spellings_of_non_spontaneous() {
    for (text, column, length) in [
        ("nonspontaneous events { }", 1, 14),
        ("non_spontaneous events { }", 1, 15),
        ("spontaneous events { }", 1, 11),
    ] {
        let mark = format!("{}{}", " ".repeat(column - 1), "~".repeat(length));
        check_section(&format!("{text}\n{mark} write `non-spontaneous events {{ … }}`"));
    }
    check_section("non spontaneous events { }\n    ~~~~~~~~~~~ write `non-spontaneous events`");
    check_section("non-spontanous events { }\n    ~~~~~~~~~~ write `spontaneous`");
    check_section("non-spontaneous event { }\n                ~~~~~ write `events`");
    check_section("non-spontaneous { }\n                ~ ");
}

#[test]
fn misspelt_declarations() {
    check_section("domain { clas A { } }\n         ~~~~ write `class`");
    check_section("domain { abstrct class A { } }\n         ~~~~~~~ write `abstract`");
    check_section("domain { enumm E { a } }\n         ~~~~~ write `enum`");
    check_section("channels { A.b ovr C.d }\n               ~~~ write `over`");
    check_section("class A { }\n~~~~~ put classes and enums into `domain Name { … }`");
    check_section("a -> b.c()\n~ put messages into the body of a scenario");
}

#[test]
fn misspelt_scenarios() {
    check_item("guarante scenario S { a -> b.c() }\n~~~~~~~~ write `guarantee`");
    check_item("guarentee scenario S { a -> b.c() }\n~~~~~~~~~ write `guarantee`");
    check_item("assumtion scenario S { a -> b.c() }\n~~~~~~~~~ write `assumption`");
    check_item("existencial scenario S { a -> b.c() }\n~~~~~~~~~~~ write `existential`");
    check_item("guarantee scenaro S { a -> b.c() }\n          ~~~~~~~ write `scenario`");
    check_item(
        "guarantee scenario S bindngs [a = b] { a -> b.c() }\n                     ~~~~~~~ write `bindings`",
    );
    check_item(
        "scenario S { a -> b.c() }\n~~~~~~~~ write `guarantee scenario`, `assumption scenario` or `existential scenario`",
    );
    check_item("role A a\n~~~~ write `static role` or `dynamic role`");
    check_item("dynamc role A a\n~~~~~~ write `dynamic`");
    check_item("dynamic rol A a\n        ~~~ write `role`");
    check_item("eventually a -> b.c()\n~~~~~~~~~~ put messages into the body of a scenario");
    check_item(
        "constraints [ ]\n~~~~~~~~~~~ move it behind the body of a scenario: `{ … } constraints [ … ]`",
    );
    check_item("channels { }\n~~~~~~~~ close the collaboration before the next section begins");
}

#[test]
fn misspelt_fragments() {
    check_body("eventualy a -> b.c()\n~~~~~~~~~ write `eventually`");
    check_body("strcit a -> b.c()\n~~~~~~ write `strict`");
    check_body("strcit eventually a -> b.c()\n~~~~~~ write `strict`");
    check_body("strict eventualy a -> b.c()\n       ~~~~~~~~~ write `eventually`");
    check_body("monitored urgnet a -> b.c()\n          ~~~~~~ write `urgent`");
    check_body("commited a -> b.c()\n~~~~~~~~ write `committed`");
    check_body("wiat [a]\n~~~~ write `wait`");
    check_body("wait eventualy [a]\n     ~~~~~~~~~ write `eventually`");
    check_body("whlie [a] { a -> b.c() }\n~~~~~ write `while`");
    check_body("interupt [a]\n~~~~~~~~ write `interrupt`");
    check_body("violaton [a]\n~~~~~~~~ write `violation`");
    check_body("alternativ { a -> b.c() }\n~~~~~~~~~~ write `alternative`");
    check_body("paralell { a -> b.c() } and { a -> b.c() }\n~~~~~~~~ write `parallel`");
    check_body("alternative { a -> b.c() } ro { a -> b.c() }\n                           ~~ write `or`");
    check_body("vra bool x = true\n~~~ write `var`");
    check_body("vra 0..=3 x\n~~~ write `var`");
    check_body("a -> b.c(bnd x)\n         ~~~ write `bind`");
}

#[test]
fn misspelt_constraints() {
    check_body("{ a -> b.c() } constraint [ ]\n               ~~~~~~~~~~ write `constraints`");
    check_item(
        "guarantee scenario S { a -> b.c() } contraints [ ]\n                                    ~~~~~~~~~~ write `constraints`",
    );
    check_body(
        "{ a -> b.c() } constraints [ forbiden a -> b.c() ]\n                             ~~~~~~~~ write `forbidden`",
    );
    check_body(
        "{ a -> b.c() } constraints [ a -> b.c() ]\n                             ~ write one of them before the message",
    );
    check_body("forbidden a -> b.c()\n~~~~~~~~~ move it behind a body: `{ … } constraints [ forbidden … ]`");
    check_body(
        "interrupt a -> b.c()\n          ~ move a constraint behind the body: `{ … } constraints [ interrupt … ]`, or write a condition in `[ … ]`",
    );
}

#[test]
fn words_of_other_languages() {
    check_body("if [a] { a -> b.c() }\n~~ write `alternative [ … ] { … }`");
    check_body("if (a) { a -> b.c() }\n~~ write `alternative [ … ] { … }`");
    check_body(
        "alternative [a] { a -> b.c() } else { a -> b.c() }\n                               ~~~~ write `or`",
    );
    check_body("loop { a -> b.c() }\n~~~~ write `while`");
    check_body("par { a -> b.c() }\n~~~ write `parallel`");
}

#[test]
fn order_of_modifiers() {
    check_body("eventually strict a -> b.c()\n           ~~~~~~ write `strict eventually`");
    check_body("urgent monitored a -> b.c()\n       ~~~~~~~~~ write `monitored urgent`");
    check_body("monitored strict urgent a -> b.c()\n          ~~~~~~ write `strict monitored urgent`");
    check_body("eventually urgent a -> b.c()\n           ~~~~~~ write only one of `eventually` and `urgent`");
    check_body("strict strict a -> b.c()\n       ~~~~~~ write `strict`");
    check_body("wait eventually strict [a]\n                ~~~~~~ write `wait strict eventually`");
    check_body("monitored a -> b.c()\n          ~ write one of them behind `monitored`");
}

#[test]
fn arrows() {
    check_body("a → b.c()\n  ~ write `->`");
    check_body("a => b.c()\n  ~~ write `->` instead of `=>`");
    check_body("a --> b.c()\n  ~~~ write `->` instead of `-->`");
    check_body("a ~> b.c()\n  ~~ write `->` instead of `~>`");
    check_body("a.b()\n ~ name the sender, too: `sender -> receiver.operation()`");
    check_body("a -> b::c()\n      ~~ write `.` instead of `::`");
    check_body("a -> b->c()\n      ~~ write `.` instead of `->`");
}

#[test]
fn conditions() {
    check_body("wait [a = b]\n        ~ write `==` instead of `=`");
    check_body("wait [a & b]\n        ~ write `&&` instead of `&`");
    check_body("wait [a | b]\n        ~ write `||` instead of `|`");
    check_body("wait [a and b]\n        ~~~ write `&&` instead of `and`");
    check_body("wait [a or !b]\n        ~~ write `||` instead of `or`");
    check_body("wait [not a]\n      ~~~ write `!` instead of `not`");
    check_body("wait [not (a)]\n      ~~~ write `!` instead of `not`");
    check_body("wait [a <> b]\n        ~~ write `!=` instead of `<>`");
    check_body("wait [a === b]\n        ~~~ write `==` instead of `===`");
    check_body("wait [a =< b]\n        ~~ write `<=` instead of `=<`");
    check_body("wait [a ≤ b]\n        ~ write `<=`");
    check_body("wait [a ∧ b]\n        ~ write `&&`");
    check_body("wait (a)\n     ~ write `[ … ]` instead of `( … )`");
    check_body("while (a) { a -> b.c() }\n      ~ write `[ … ]` instead of `( … )`");
    check_body("wait a.b == c\n     ~ put the condition into brackets: `[ … ]`");
    check_body("interrupt !a\n          ~ put the condition into brackets: `[ … ]`");
}

#[test]
fn names_that_look_like_operators() {
    for body in [
        "wait [not]",
        "x = not not -> b.c()",
        "x = a is -> b.c()",
        "not -> b.c()",
        "x = not y = not",
        "wait [a == not]",
    ] {
        let text = format!("specification X {{ collaboration C {{ guarantee scenario S {{ {body} }} }} }}");
        assert_eq!(parse(&text).1, [], "{text}");
    }
}

#[test]
fn assignments_and_variables() {
    check_body("x := 3\n  ~~ write `=` instead of `:=`");
    check_body("var x = 3\n      ~ write the type before the name: `var bool name = …`");
    check_body("var x: bool\n     ~ write the type before the name: `var bool name = …`");
    check_section(
        "effects { A -> B.c() { receiver.x := 1 } }\n                                  ~~ write `=` instead of `:=`",
    );
    check_section("object a: A { x = 3 }\n                ~ write `:` instead of `=`");
    check_class("a = bool\n  ~ write `:` instead of `=`");
    check_class("bool a\n~~~~ write the name before the type: `name: type`");
    check_class("a(bool b)\n  ~~~~ write the name before the type: `name: type`");
}

#[test]
fn separators_and_quotes() {
    check_body("a -> b.c(1 2)\n           ~ write `,` before `2`");
    check_body("a -> b.c(x; y)\n          ~ write `,` instead of `;`");
    check_section("domain { enum E { a b } }\n                    ~ write `,` before `b`");
    check_body("a -> b.c(\"x\")\n         ~~~ remove the quotes: names and enum literals stand alone");
    check_body("a -> b.c('x')\n         ~~~ remove the quotes: names and enum literals stand alone");
    check_class("a: E = \"x\"\n       ~~~ remove the quotes: names and enum literals stand alone");
}

#[test]
fn comments_of_other_languages() {
    check_body("a -> b.c() # isn't {\n           ~ begin a comment with `//`");
    check("# first\n~ begin a comment with `//`\nspecification X { }");
}
