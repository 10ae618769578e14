//! Arguments as they are typed into a shell.

/// An argument, in quotes if a shell would take it for something else.
#[must_use]
pub fn quoted(argument: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "_./-+=:,@%".contains(c);
    if !argument.is_empty() && argument.chars().all(is_plain) {
        return argument.to_owned();
    }
    format!("'{}'", argument.replace('\'', r"'\''"))
}

/// An input by the name that messages have for it: stdin is `-`.
#[must_use]
pub fn input(name: &str) -> String {
    if name == "<stdin>" { "-".to_owned() } else { quoted(name) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(argument: &str, expect: &str) {
        assert_eq!(quoted(argument), expect);
    }

    #[test]
    fn quotes_where_a_shell_needs_them() {
        check("specs/lamp-2.sml", "specs/lamp-2.sml");
        check("über.sml", "über.sml");
        check("", "''");
        check("my lamp.sml", "'my lamp.sml'");
        check("it's $HOME", r"'it'\''s $HOME'");
        check("a;b", "'a;b'");
        check(r"specs\lamp.sml", r"'specs\lamp.sml'");
    }

    #[test]
    fn stdin_is_a_dash() {
        assert_eq!((input("<stdin>"), input("a b")), ("-".to_owned(), "'a b'".to_owned()));
    }
}
