//! Every kind of mistake, at its place.

use super::{parse, unmark};
use std::io::{self, Read as _};

use crate::diagnostic::Code;
use crate::syntax::{FileId, MAX_BYTES, Pos, decode, parse_text, parse_tokens, read_bounded};

/// The diagnostics of the text are exactly its marks, each `~~~~ CODE message` under the place.
#[track_caller]
fn check(marked: &str) {
    let (text, marks) = unmark(marked);
    let (_, errors) = parse(&text);
    let found: Vec<_> = errors.iter().map(|d| (d.span, format!("{} {}", d.code as u16, d.message))).collect();
    assert_eq!(found, marks, "{text}");
}

/// As [`check`] for the body of a scenario.
#[track_caller]
fn check_body(marked: &str) {
    check(&format!("specification X {{ collaboration C {{ guarantee scenario S {{\n{marked}\n}} }} }}"));
}

/// As [`check`] for the members of a class.
#[track_caller]
fn check_class(marked: &str) {
    check(&format!("specification X {{ domain {{ class A {{\n{marked}\n}} }} }}"));
}

#[test]
fn nothing() {
    for text in ["", "\u{feff}", "  \r\n", "// only\n/* a /* comment */ */", "/// and text"] {
        let (tree, errors) = parse(text);
        assert!(tree.is_none());
        assert_eq!(errors.len(), 1, "{text}");
        assert_eq!((errors[0].code, errors[0].span.start.column), (Code::Empty, 1));
    }
}

#[test]
fn no_tokens() {
    let (_, errors) = parse_tokens(proc_macro2::TokenStream::new(), FileId(0));
    assert_eq!(errors[0].code, Code::Empty);
}

#[test]
fn lone_delimiters() {
    check("{\n~ 2 unclosed `{`");
    check("}\n~ 2 `}` closes nothing");
    check("{}\n~ 4 expected `specification`, found `{`");
    check(")\n~ 2 `)` closes nothing");
}

#[test]
fn header() {
    let (_, errors) = parse("specification\n");
    assert_eq!(errors[0].message, "expected the name of the specification, found the end of the file");
    assert_eq!(errors[0].span.start, Pos { line: 1, column: 14 });
    check("system X { }\n       ~ 4 expected `specification`, found `X`");
    check("specification X\n{ object }\n         ~ 4 expected the name of the object, found `}`");
}

#[test]
fn stray_characters() {
    check_class("a: bool €\n        ~ 1 stray character `€`");
    check_class("a: bool \\ b: bool\n        ~ 1 stray character `\\`");
    check_class("a: bool ``\n        ~~ 1 stray backtick");
    check_class("a: bool \u{0} b: bool\n        ~ 1 stray character `U+0000`");
    check_class("a: bool = 'a'\n          ~~~ 1 stray character `'`");
    check_class("a: bool = 'a\n          ~~ 1 stray character `'`");
    check_class("a: bool =\n€€\n~~ 1 stray character `€`\n");
}

#[test]
fn a_stray_character_hides_no_later_mistake() {
    check(
        "specification X € {\n                ~ 1 stray character `€`\n  object 1\n         ~ 4 expected the name of the object, found `1`\n}",
    );
}

#[test]
fn unclosed_delimiters() {
    check("specification X {\n                ~ 2 unclosed `{`\n");
    check_body("wait [a\n     ~ 2 unclosed `[`");
    check_body("a -> b.c(\n        ~ 2 unclosed `(`\nd -> e.f()");
    check_body("wait [a)\n       ~ 2 expected `]`, found `)`");
}

#[test]
fn indentation_shows_what_is_unclosed() {
    check(
        "\
specification X {
  collaboration C {
    guarantee scenario S {
                         ~ 2 unclosed `{`
      a -> b.c()
    guarantee scenario T {
      a -> b.c()
    }
  }
}
",
    );
}

#[test]
fn one_closing_brace_too_many() {
    check(
        "\
specification X {
  domain { } }
}
~ 2 `}` closes nothing
",
    );
}

#[test]
fn a_text_cut_short_is_read_to_its_end() {
    check(
        "specification X {\n                ~ 2 unclosed `{`\n  object 1\n         ~ 4 expected the name of the object, found `1`\n  object",
    );
}

#[test]
fn mistakes_before_an_unclosed_delimiter_are_told() {
    check(
        "specification X {\n  object 1\n         ~ 4 expected the name of the object, found `1`\n  domain {\n         ~ 2 unclosed `{`\n}\n}\nobject (",
    );
}

#[test]
fn unterminated() {
    check("import \"a.sml\n       ~ 3 unclosed quote\nspecification X { }");
    check("specification X { /* a /* b */ }\n                  ~~ 3 unclosed block comment");
    check("import \"a\\\"\n       ~ 3 unclosed quote");
    check("import \"a\\\n       ~ 3 unclosed quote\n");
}

#[test]
fn escapes() {
    check("import \"..\\quux.sml\"\n          ~~ 1 unknown escape `\\q` in a string\nspecification X { }");
}

#[test]
fn raw_text() {
    check("import r\"a\"\n       ~ 1 raw text does not exist here\nspecification X { }");
    check("import r#\"a\"#\n       ~~ 1 raw text does not exist here\nspecification X { }");
    check_class("r#move()\n~~ 1 raw text does not exist here");
}

#[test]
fn numbers() {
    check_class("a: 0x10..=20\n   ~~~~ 7 `0x10` is not a plain decimal integer");
    check_class("a: 0..=1_000\n       ~~~~~ 7 `1_000` is not a plain decimal integer");
    check_class("a: 1u8..=3\n   ~~~ 7 `1u8` is not a plain decimal integer");
    check_class("a: 1.5..=3\n   ~~~ 7 `1.5` is not a plain decimal integer");
    check_class("a: 0..=1.\n       ~~ 7 `1.` is not a plain decimal integer");
    check_class("a: 0..=1e5\n       ~~~ 7 `1e5` is not a plain decimal integer");
    check_class("a: 0..=0xZZ\n       ~~~~ 7 `0xZZ` is not a plain decimal integer");
    check_class("a: 0..5\n    ~~ 4 expected `..=` and the largest value, found `..`");
    check_class(
        "a: 0..=9223372036854775808\n       ~~~~~~~~~~~~~~~~~~~ 8 `9223372036854775808` is no 64-bit integer",
    );
    check_class(
        "a: -9223372036854775809..=0\n   ~~~~~~~~~~~~~~~~~~~~ 8 `-9223372036854775809` is no 64-bit integer",
    );
}

#[test]
fn names() {
    check_class("_a: bool\n~~ 6 `_a` is not a name");
    check_class("_: bool\n~ 6 `_` is not a name");
    check_class("türe: bool\n~~~~ 6 `türe` is not a name");
    check_class("größe2: bool\n~~~~~~ 6 `größe2` is not a name");
    check_class("\"a\": bool\n~~~ 4 expected an attribute or operation, found a string");
}

#[test]
fn reserved_words() {
    check_class("while()\n~~~~~ 5 expected an attribute or operation, found the keyword `while`");
    check_body("var bool true\n         ~~~~ 5 expected the name of the variable, found the keyword `true`");
    check_body("a -> b.wait()\n       ~~~~ 5 expected the operation, found the keyword `wait`");
}

#[test]
fn old_types() {
    check_class("a: EInt\n   ~~~~ 9 `EInt` is not a type here");
    check_class("a: EBoolean\n   ~~~~~~~~ 9 `EBoolean` is not a type here");
    check_body("var EString s\n    ~~~~~~~ 9 `EString` is not a type here");
}

#[test]
fn fragments() {
    check_body("a b.c()\n  ~ 4 expected `->` and the receiver, found `b`");
    check_body("a -> b c()\n       ~ 4 expected `.` and the operation, found `c`");
    check_body("a - > b.c()\n  ~ 4 expected `->` and the receiver, found `-`");
    check_body(
        "eventually strict a -> b.c()\n           ~~~~~~ 4 expected the sender of the message, found the keyword `strict`",
    );
    check_body(
        "monitored a -> b.c()\n          ~ 4 expected `eventually`, `urgent`, `requested` or `committed`, found `a`",
    );
    check_body("wait a\n     ~ 4 expected `[` and a condition, found `a`");
    check_body("wait []\n      ~ 4 expected an expression, found `]`");
    check_body("or { }\n~~ 4 expected a fragment, found the keyword `or`");
    check_body("alternative\n[a] a -> b.c()\n    ~ 4 expected `{`, found `a`");
    check_body("a -> b.c(1 2)\n           ~ 4 expected `,` or `)`, found `2`");
    check_body("a -> b.c(,)\n         ~ 4 expected an expression, found `,`");
    check_body("a == b\n  ~~ 4 expected `->` and the receiver, found `==`");
    check_body("; a -> b.c()\n~ 4 expected a fragment, found `;`");
}

#[test]
fn expressions() {
    check_body("wait [a < b < c]\n            ~ 13 comparisons do not chain");
    check_body("wait [a == b != c]\n             ~~ 13 comparisons do not chain");
    check_body("wait [a +]\n         ~ 4 expected an expression, found `]`");
    check_body("wait [a & b]\n        ~ 4 `&` is no operator of expressions");
    check_body("wait [a = b]\n        ~ 4 `=` is no operator of expressions");
    check_body("wait [E::b]\n        ~ 4 expected a literal of the enum, found `:`");
    check_body("wait [a.1]\n        ~ 4 expected the name of an attribute, found `1`");
}

#[test]
fn declarations() {
    check(
        "specification X { enum E { } }\n                  ~~~~ 4 expected a section, found the keyword `enum`",
    );
    check(
        "specification X { domain { enum E { } } }\n                                    ~ 4 expected a literal of the enum, found `}`",
    );
    check(
        "specification X { domain { enum E { a b } } }\n                                      ~ 4 expected `,` or `}`, found `b`",
    );
    check_class("a(b c: bool)\n    ~ 4 expected `:` and the type of the parameter, found `c`");
    check_class("a: bool = b.c\n           ~ 4 expected the end of the literal, found `.`");
    check(
        "specification X { non spontaneous events { } }\n                      ~~~~~~~~~~~ 4 expected `-` of `non-spontaneous`, found `spontaneous`",
    );
    check(
        "specification X { parameter ranges { A.b(c = [a..=3]) } }\n                                              ~ 4 only integers have a range between them",
    );
    check(
        "specification X { channels { A.b C.d } }\n                                 ~ 4 expected `over`, found `C`",
    );
    check(
        "specification X { } object o: C\n                    ~~~~~~ 4 expected the end of the file, found the keyword `object`",
    );
    check("import a specification X { }\n       ~ 4 expected the path of a file in quotes, found `a`");
    check(
        "specification X { collaboration C { guarantee scenario S { } dynamic role A a } }\n                                                             ~~~~~~~ 4 role behind a scenario",
    );
}

#[test]
fn several_mistakes_in_one_run() {
    check(
        "\
specification X {
  domain {
    class A { b }
                ~ 4 expected `:` of an attribute or `(` of an operation, found `}`
    class { }
          ~ 4 expected the name of the class, found `{`
    class C { d: bool }
  }
  object
  effects {
  ~~~~~~~ 5 expected the name of the object, found the keyword `effects`
    A -> B.c() { d }
                   ~ 4 expected `=` and the new value, found `}`
    A -> B { }
           ~ 4 expected `.` and the operation, found `{`
    A -> B.c() { d = 1 }
  }
  collaboration C {
    guarantee scenario S { a }
                             ~ 4 expected `->` and the receiver, found `}`
    guarante scenario T { a -> b.c() }
    ~~~~~~~~ 4 expected a role, or an assumption, guarantee or existential scenario, found `guarante`
    assumption scenario U { a -> b.c() } constraints [ never ]
                                                       ~~~~~ 4 expected `forbidden`, `ignore`, `interrupt` or `consider`, found `never`
    existential scenario V { a -> b.c() }
  }
}
",
    );
}

#[test]
fn depth() {
    for open in ["(", "[", "{", "!", "- ", "a => ", "{ [ (", "(a + b * (", "(a || b && c == d + e * (! "] {
        let text = format!(
            "specification X {{ collaboration C {{ guarantee scenario S {{ wait [{}",
            open.repeat(50_000)
        );
        let (_, errors) = parse(&text);
        assert_eq!(
            errors[0].code,
            if open.contains(['(', '[', '{']) { Code::TooDeep } else { Code::Delimiter },
            "{open}"
        );
        let text = format!("{text}a] }} }} }}");
        assert_eq!(parse(&text).1[0].code, Code::TooDeep, "{open}");
    }
    let chain = vec!["a"; 100_000].join(" && ");
    let text =
        format!("specification X {{ collaboration C {{ guarantee scenario S {{ wait [{chain}] }} }} }}");
    assert_eq!(parse(&text).1[0].code, Code::TooDeep);
}

#[test]
fn depth_of_tokens() {
    use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
    for delimiter in [Delimiter::None, Delimiter::Brace] {
        let mut tokens = TokenStream::new();
        for _ in 0..10_000 {
            tokens = TokenStream::from(TokenTree::Group(Group::new(delimiter, tokens)));
        }
        assert_eq!(parse_tokens(tokens, FileId(0)).1[0].code, Code::TooDeep);
    }
}

#[test]
fn deepest_that_is_read() {
    for (open, close, levels) in
        [("(", ")", 120), ("(a || b && c == d + e * (", "))", 17), ("!", "", 120), ("a => ", "", 120)]
    {
        let (open, close) = (open.repeat(levels), close.repeat(levels));
        let text = format!(
            "specification X {{ collaboration C {{ guarantee scenario S {{ wait [{open}a{close}] }} }} }}"
        );
        assert_eq!(parse(&text).1, [], "{text}");
    }
    let (open, close, not) = ("parallel { } and { ".repeat(80), "}".repeat(80), "!".repeat(40));
    let text = format!(
        "specification X {{ collaboration C {{ guarantee scenario S {{ {open} wait [{not}a] {close} }} }} }}"
    );
    assert_eq!(parse(&text).1, []);
}

#[test]
fn encoding() {
    assert_eq!(decode("é".as_bytes(), FileId(0)), Ok("é"));
    let error = decode(b"\xef\xbb\xbfa\n\xc3\xa9b\xff\n", FileId(0)).expect_err("no UTF-8");
    assert_eq!((error.code, error.span.start), (Code::Encoding, Pos { line: 2, column: 3 }));
    let text = "specification X { }\n";
    let wide = |order: fn(u16) -> [u8; 2]| text.encode_utf16().flat_map(order).collect::<Vec<u8>>();
    for bytes in [
        wide(u16::to_le_bytes),
        wide(u16::to_be_bytes),
        [&[0xFF, 0xFE][..], &wide(u16::to_le_bytes)].concat(),
        [&[0xFE, 0xFF][..], &wide(u16::to_be_bytes)].concat(),
    ] {
        let error = decode(&bytes, FileId(0)).expect_err("UTF-16");
        assert_eq!(error.message, "the file is UTF-16 text, not UTF-8");
    }
    for good in ["", "a", "\u{0}\u{0}\u{0}\u{0}"] {
        assert_eq!(decode(good.as_bytes(), FileId(0)), Ok(good));
    }
}

#[test]
fn a_file_without_end_is_not_read_to_its_end() {
    let read = |length| read_bounded(io::repeat(b' ').take(length)).map(|bytes| bytes.len() as u64);
    assert_eq!(read(MAX_BYTES).expect("the largest file"), MAX_BYTES);
    let error = read_bounded(io::repeat(b' ')).expect_err("endless");
    assert_eq!(error.to_string(), "it is larger than 16 MiB, so it is neither a specification nor a plant");
}

#[test]
fn a_text_of_errors_is_given_up() {
    assert_eq!(parse(&"€ ü ".repeat(100_000)).1.len(), 1000);
}

/// Both routes tell the same, except where Rust's lexer accepts nothing.
#[test]
fn tokens_tell_the_same() {
    for text in [
        "specification X { domain { class A { _a: bool } class B { b: 0x1..=3 c } class C { d: EInt } } }",
        "specification X { collaboration C { guarantee scenario S { a } } }",
        "specification while { }",
        "specification X { object a: 1 }",
    ] {
        let tokens: proc_macro2::TokenStream = text.parse().expect("tokens of Rust");
        assert_eq!(parse_tokens(tokens, FileId(3)), parse_text(text, FileId(3)));
    }
}
