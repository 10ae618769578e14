//! What is read: trees, places, older spellings.

use super::{corpus, parse, tree, unmark};
use crate::syntax::ast::{ExprKind, File, FragmentKind, ScenarioKind, Section};
use crate::syntax::{FileId, parse_text, parse_tokens, print};

/// The tree without its places.
pub(super) fn shape(file: &File) -> String {
    let text = format!("{file:?}");
    let mut pieces = text.split(": Span {");
    let mut shape = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        shape.push_str(piece.split_once("} }").expect("the end of a place").1);
    }
    shape
}

#[track_caller]
pub(super) fn round_trip(text: &str) {
    let first = tree(text);
    let printed = print(&first);
    assert_eq!(shape(&first), shape(&tree(&printed)), "{printed}");
}

/// Both texts mean the same tree.
#[track_caller]
fn same(one: &str, other: &str) {
    assert_eq!(shape(&tree(one)), shape(&tree(other)), "{one}\n{other}");
}

fn scenario(body: &str) -> String {
    format!("specification X {{ collaboration C {{ guarantee scenario S {body} }} }}")
}

#[track_caller]
fn same_body(one: &str, other: &str) {
    same(&scenario(&format!("{{ {one} }}")), &scenario(&format!("{{ {other} }}")));
}

/// The expression prints as `expect`.
#[track_caller]
fn check_expr(text: &str, expect: &str) {
    let text = scenario(&format!("{{ wait [{text}] }}"));
    let printed = print(&tree(&text));
    let line = printed.lines().find_map(|line| line.trim().strip_prefix("wait ["));
    assert_eq!(line, Some(format!("{expect}]").as_str()));
    round_trip(&text);
}

fn fragments(file: &File) -> &[crate::syntax::ast::Fragment] {
    let Some(Section::Collaboration(c)) = file.sections.last() else { panic!("no collaboration") };
    &c.scenarios[0].body.fragments
}

/// The first condition waited for stands at the first mark, its operands at the next.
#[track_caller]
fn check_expr_places(marked: &str) {
    let (text, marks) = unmark(&scenario(&format!("{{\n{marked}\n}}")));
    let file = tree(&text);
    let FragmentKind::Wait { condition, .. } = &fragments(&file)[0].kind else { panic!("no wait") };
    let mut found = vec![condition.span];
    match &condition.kind {
        ExprKind::Binary(_, left, right) => found.extend([left.span, right.span]),
        ExprKind::Unary(_, operand) => found.push(operand.span),
        _ => {}
    }
    assert_eq!(found, marks.into_iter().map(|(span, _)| span).collect::<Vec<_>>());
}

/// The first fragment stands at the first mark; if it is a message, itself at the next, its arguments at the others.
#[track_caller]
fn check_fragment_places(marked: &str) {
    let (text, marks) = unmark(&scenario(&format!("{{\n{marked}\n}}")));
    let file = tree(&text);
    let fragment = &fragments(&file)[0];
    let mut found = vec![fragment.span];
    if let FragmentKind::Message(_, message) = &fragment.kind {
        found.push(message.span);
        found.extend(message.arguments.iter().map(|argument| argument.span));
    }
    assert_eq!(found, marks.into_iter().map(|(span, _)| span).collect::<Vec<_>>());
}

const EVERYTHING: &str = r#"
import "a/b.sml";
import "c\\d \"e\".sml"
specification Everything {
  domain d {
    enum Color { red, green, blue, }
    abstract class Base { level: -1..=3 = -1; color: Color = Color:red, next: Base = null }
    class Part: Base { ready: bool = true move(place: Base, how: 0..=3) self() type(match: bool,) };
  }
  object part: Part { level: 2 color: red, ready: false next: other };
  object other: Part
  effects {
    Part -> part.move(place, how) { receiver.next = place; receiver.level = how + 1 * -2 sender.ready = !(how < 2), }
    part -> Part.self() { }
  }
  controllable { Part, Base }
  non-spontaneous events { Part.move; Part.self }
  parameter ranges { Part.move(place = [part, other], how = [0, 1..2 -3..=-1, -3..-2,],) Part.type(match = [true, Color:red, null]) }
  channels { Part.move over Part.next Part.move over Base.next; }
  collaboration C {
    static role Part part
    dynamic role Base x;
    /// First line
    ///   indented

    assumption scenario A bindings [x = part.next, y = null] {
      var Base v = x; var -1..=1 n
      n = n - 1
      { a -> b.c } constraints [forbidden a -> b.c, ignore a -> b.d(*); interrupt a -> b.e(1) consider a -> b.f()]
      strict monitored eventually a -> b.c(*, bind v, n + 1, Color:red, null,)
      strict a -> b.c() urgent a -> b.c() monitored requested a -> b.c(); committed a -> b.setX(-1)
      alternative [n == 1] { a -> b.c() } or { a -> b.c() } constraints [ignore a -> b.c()] or [x.y.z] { }
      parallel { a -> b.c() } and { { } } and { }
      while [true] { wait strict eventually [a => b => c] } while { a -> b.c() }
      interrupt [!a || b && (c || d)] violation [(a => b) => c]; wait [a]
    } constraints []
    existential scenario E { a -> b.c() }
    guarantee scenario G { a -> b.c() }
  }
}
"#;

#[test]
fn everything_round_trips() {
    round_trip(EVERYTHING);
}

#[test]
fn corpus_round_trips() {
    for (_, text) in corpus() {
        round_trip(&text);
    }
}

#[test]
fn tokens_give_the_same_tree() {
    for text in corpus().into_iter().map(|(_, text)| text).chain([EVERYTHING.to_owned()]) {
        let tokens: proc_macro2::TokenStream = text.parse().expect("tokens of Rust");
        assert_eq!(parse_tokens(tokens, FileId(1)), parse_text(&text, FileId(1)));
    }
}

#[test]
fn places_are_those_of_each_text() {
    let text = "specification Ä {}";
    let first = parse(text);
    assert_eq!(parse(EVERYTHING).1, []);
    assert_eq!(parse(text), first);
}

#[test]
fn byte_order_mark_and_line_ends() {
    let plain = tree(EVERYTHING);
    assert_eq!(tree(&format!("\u{feff}{EVERYTHING}")), plain);
    assert_eq!(tree(&EVERYTHING.replace('\n', "\r\n")), plain);
    same(&EVERYTHING.replace('\n', "\n\r"), EVERYTHING);
}

#[test]
fn documentation_comments_may_stand_anywhere() {
    let text =
        "//! inner\nspecification /** a */ X { /// b\n collaboration C { /// c\n static role A /*! d */ a
        /// first
        /** not a line */
        ///second
        // plain
        //// plain
        guarantee scenario /// e\n S { wait /// f\n [a /** g */ && /// h\n b] /// i\n } /// j\n } } /// k";
    let file = tree(text);
    let Some(Section::Collaboration(c)) = file.sections.last() else { panic!("no collaboration") };
    assert_eq!(c.scenarios[0].requirement, ["first", "second"]);
    let tokens: proc_macro2::TokenStream = text.parse().expect("tokens of Rust");
    assert_eq!(parse_tokens(tokens, FileId(0)), (Some(file), Vec::new()));
}

#[test]
fn older_spellings() {
    same_body("message strict eventually a -> b.c()", "strict eventually a -> b.c()");
    same_body("message a -> b.c()", "a -> b.c");
    same_body("wait until [a]", "wait [a]");
    same_body("wait strict eventually until [a]", "wait strict eventually [a]");
    same_body("interrupt if [a] violation if [b]", "interrupt [a] violation [b]");
    same_body("a -> b.c(bind to v)", "a -> b.c(bind v)");
    same(
        &scenario("with dynamic bindings [bind r to a.b bind s to c] { }"),
        &scenario("bindings [r = a.b, s = c] { }"),
    );
    same(
        &scenario("{ } constraints [forbidden message a -> b.c()]"),
        &scenario("{ } constraints [forbidden a -> b.c()]"),
    );
    let plain = scenario("{ }");
    same(&plain.replace("guarantee", "specification"), &plain);
    same(&plain.replace("guarantee", "requirement"), &plain);
    same(&format!("system {plain}"), &plain);
}

#[test]
fn words_that_are_keywords_only_in_their_place() {
    for name in
        ["message", "to", "until", "events", "over", "ranges", "system", "requirement", "self", "fn", "in"]
    {
        round_trip(&scenario(&format!(
            "{{ var bool {name} {name} = {name} {name} -> {name}.{name}(bind to {name}, {name}) }}"
        )));
    }
    same_body("a -> b.c(bind to)", "a -> b.c(bind to to)");
    same_body("message message -> b.c()", "message -> b.c()");
}

#[test]
fn kinds_of_scenario() {
    for (word, kind) in [
        ("assumption", ScenarioKind::Assumption),
        ("guarantee", ScenarioKind::Guarantee),
        ("existential", ScenarioKind::Existential),
    ] {
        let file = tree(&scenario("{ }").replace("guarantee", word));
        let Some(Section::Collaboration(c)) = file.sections.last() else { panic!("no collaboration") };
        assert_eq!(c.scenarios[0].kind, kind);
    }
}

#[test]
fn operators() {
    check_expr("(a) + (b*c)", "a + b * c");
    check_expr("(a+b)*c", "(a + b) * c");
    check_expr("a-b-c", "a - b - c");
    check_expr("a-(b-c)", "a - (b - c)");
    check_expr("a=>b=>c", "a => b => c");
    check_expr("(a=>b)=>c", "(a => b) => c");
    check_expr("a||b&&c==d", "a || b && c == d");
    check_expr("(a==b)==c", "(a == b) == c");
    check_expr("a==-1", "a == -1");
    check_expr("a<-1&&b>=-c", "a < -1 && b >= -c");
    check_expr("!!a", "!!a");
    check_expr("!(a&&b)", "!(a && b)");
    check_expr("- 1", "-1");
    check_expr("-(1)", "-(1)");
    check_expr("--1", "-(-1)");
    check_expr("a--1", "a - -1");
    check_expr("a - - - b", "a - --b");
    check_expr("-9223372036854775808", "-9223372036854775808");
    check_expr("007", "7");
    check_expr("E:red!=x.y", "E:red != x.y");
    check_expr("a==b&&c==d", "a == b && c == d");
}

#[test]
fn places_of_expressions() {
    check_expr_places("wait [a.b.c]\n      ~~~~~");
    check_expr_places("wait [(a)]\n       ~");
    check_expr_places("wait [a + b * c]\n      ~~~~~~~~~\n      ~\n          ~~~~~");
    check_expr_places("wait [(a + b) * c]\n      ~~~~~~~~~~~\n       ~~~~~\n                ~");
    check_expr_places("wait [a == - 12]\n      ~~~~~~~~~\n      ~\n           ~~~~");
    check_expr_places("wait [!(a)]\n      ~~~~\n        ~");
    check_expr_places(
        "/* ä */ wait [Ex:l <= null]\n              ~~~~~~~~~~~~\n              ~~~~\n                      ~~~~",
    );
}

#[test]
fn places_of_fragments() {
    check_fragment_places(
        "strict urgent aa -> b.c(*, bind v, x+1)\n~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~\n              ~~~~~~~~~~~~~~~~~~~~~~~~~\n                        ~\n                           ~~~~~~\n                                   ~~~",
    );
    check_fragment_places("  a -> b.cde;\n  ~~~~~~~~~~\n  ~~~~~~~~~~");
    check_fragment_places("wait eventually [a];\n~~~~~~~~~~~~~~~~~~~");
    check_fragment_places("var 1..=3 x = 2 ;\n~~~~~~~~~~~~~~~");
    check_fragment_places("while { } constraints [ ]\n~~~~~~~~~~~~~~~~~~~~~~~~~");
    check_fragment_places("alternative { } or [a] { } a -> b.c()\n~~~~~~~~~~~~~~~~~~~~~~~~~~");
}

#[test]
fn places_of_bodies_and_keywords() {
    let (text, marks) = unmark(
        "specification X {\n              ~\n controllable { A }\n ~~~~~~~~~~~~\n collaboration C { guarantee scenario S { } constraints [] }\n                                        ~~~\n}",
    );
    let file = tree(&text);
    let Section::Controllable(controllable) = &file.sections[0] else { panic!("no controllable") };
    let Section::Collaboration(c) = &file.sections[1] else { panic!("no collaboration") };
    let found = [file.name.span, controllable.keyword, c.scenarios[0].body.span];
    assert_eq!(found.to_vec(), marks.into_iter().map(|(span, _)| span).collect::<Vec<_>>());
}
