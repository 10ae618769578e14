//! Reads Structured Text back, knowing nothing of the writer: tokens, initialised arrays, and a few rules that
//! strict compilers enforce.

use std::collections::BTreeMap;

/// The text with every comment replaced by a space; fails on nested and open comments.
#[track_caller]
pub(crate) fn without_comments(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(start) = rest.find("(*") {
        out.push_str(&rest[..start]);
        out.push(' ');
        let comment = &rest[start + 2..];
        let end = comment.find("*)").expect("a comment is open");
        assert!(!comment[..end].contains("(*"), "nested comment: {}", &comment[..end]);
        rest = &comment[end + 2..];
    }
    out.push_str(rest);
    assert!(!out.contains("*)"), "a comment is closed twice");
    out
}

/// Words, numbers and operators.
#[track_caller]
pub(crate) fn tokens(text: &str) -> Vec<String> {
    let text = without_comments(text);
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '#';
        let length = if word(first) {
            rest.find(|c| !word(c)).unwrap_or(rest.len())
        } else if [":=", "..", "<>", "<=", ">=", "//"].iter().any(|operator| rest.starts_with(operator)) {
            2
        } else {
            first.len_utf8()
        };
        tokens.push(rest[..length].to_owned());
        rest = rest[length..].trim_start();
    }
    tokens
}

/// Upper bound and values by name.
pub(crate) type Arrays = BTreeMap<String, (usize, Vec<u32>)>;

/// All declarations `name : ARRAY [0..n] OF type := [values];`.
#[track_caller]
pub(crate) fn arrays(text: &str) -> Arrays {
    let tokens = tokens(text);
    let mut arrays = Arrays::new();
    for start in 0..tokens.len() {
        if tokens[start] != "ARRAY" || tokens[start - 1] == "TO" {
            continue;
        }
        let [name, colon, _, open, zero, dots, bound, close, of, _, assign] = &tokens[start - 2..start + 9]
        else {
            panic!("a declaration is cut off");
        };
        assert_eq!(
            [colon, open, zero, dots, close, of].map(String::as_str),
            [":", "[", "0", "..", "]", "OF"]
        );
        if assign == ";" {
            continue;
        }
        assert_eq!([assign.as_str(), &tokens[start + 9]], [":=", "["]);
        let mut values = Vec::new();
        let mut at = start + 10;
        loop {
            values.push(tokens[at].parse().expect("a number"));
            match tokens[at + 1].as_str() {
                "," => at += 2,
                end => break assert_eq!([end, &tokens[at + 2]], ["]", ";"]),
            }
        }
        let before = arrays.insert(name.clone(), (bound.parse().expect("a number"), values));
        assert!(before.is_none(), "{name} twice");
    }
    arrays
}

/// Rules that a strict compiler enforces and that tokens can show.
#[track_caller]
pub(crate) fn lint(text: &str) {
    assert!(text.ends_with('\n') && !text.ends_with("\n\n"));
    for line in text.lines() {
        let numbers = line.trim_start().starts_with(|c: char| c.is_ascii_digit());
        assert!(line.chars().count() <= if numbers { 400 } else { 120 }, "too long: {line}");
        assert_eq!(line, line.trim_end(), "trailing space");
    }
    let tokens = tokens(text);
    assert!(!tokens.iter().any(|token| token == "//"), "line comment");
    check_structure(&tokens);
}

/// Opening and closing keywords match, statements end in a semicolon, no list of statements is empty.
#[track_caller]
fn check_structure(tokens: &[String]) {
    const PAIRS: [(&str, &str); 16] = [
        ("IF", "END_IF"),
        ("FOR", "END_FOR"),
        ("WHILE", "END_WHILE"),
        ("REPEAT", "END_REPEAT"),
        ("VAR", "END_VAR"),
        ("VAR_INPUT", "END_VAR"),
        ("VAR_OUTPUT", "END_VAR"),
        ("TYPE", "END_TYPE"),
        ("CASE", "END_CASE"),
        ("FUNCTION", "END_FUNCTION"),
        ("DATA_BLOCK", "END_DATA_BLOCK"),
        ("ORGANIZATION_BLOCK", "END_ORGANIZATION_BLOCK"),
        ("FUNCTION_BLOCK", "END_FUNCTION_BLOCK"),
        ("CONFIGURATION", "END_CONFIGURATION"),
        ("RESOURCE", "END_RESOURCE"),
        ("PROGRAM", "END_PROGRAM"),
    ];
    let mut open = Vec::new();
    for (index, token) in tokens.iter().enumerate() {
        let next = tokens.get(index + 1).map_or("", String::as_str);
        // `PROGRAM name WITH task` in a resource has no end.
        let instance = token == "PROGRAM" && tokens.get(index + 2).is_some_and(|token| token == "WITH");
        if let Some((_, end)) = PAIRS.iter().find(|(start, _)| start == token).filter(|_| !instance) {
            open.push(*end);
        } else if token.starts_with("END_") {
            assert_eq!(open.pop(), Some(token.as_str()), "at token {index}");
            if ["END_IF", "END_FOR", "END_WHILE", "END_REPEAT", "END_CASE"].contains(&token.as_str()) {
                assert_eq!(next, ";", "after {token}");
            }
        }
        if ["THEN", "DO", "ELSE", "REPEAT", "VAR", "VAR_INPUT", "VAR_OUTPUT", "CONSTANT"]
            .contains(&token.as_str())
        {
            let empty = next.starts_with("END_") || next.starts_with("ELS") || next == "UNTIL";
            assert!(!empty, "nothing after {token}");
        }
    }
    assert_eq!(open, [""; 0]);
}
