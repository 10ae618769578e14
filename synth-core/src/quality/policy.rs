//! Which warnings are shown, and which are as bad as errors.

use crate::diagnostic::{Code, Diagnostic, Severity};
use std::str::FromStr;

/// What to do about warnings. By default all are shown and none is denied.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Policy {
    allowed: Vec<Code>,
    denied: Vec<Code>,
    all_denied: bool,
}

impl Policy {
    /// Warnings of this code are not shown.
    #[must_use]
    pub fn allow(mut self, warning: Warning) -> Self {
        self.allowed.push(warning.0);
        self
    }

    /// Warnings of this code are as bad as errors, unless they are allowed.
    #[must_use]
    pub fn deny(mut self, warning: Warning) -> Self {
        self.denied.push(warning.0);
        self
    }

    /// Every warning that is not allowed is as bad as an error.
    #[must_use]
    pub fn deny_all(mut self) -> Self {
        self.all_denied = true;
        self
    }

    /// Whether warnings of this code are denied.
    #[must_use]
    pub fn denies_code(&self, code: Code) -> bool {
        !self.allowed.contains(&code) && (self.all_denied || self.denied.contains(&code))
    }

    /// Whether something is denied that takes more than the text to see.
    #[must_use]
    pub fn denies_plays(&self) -> bool {
        self.all_denied || self.denied.iter().any(|code| !Warning(*code).is_of_text())
    }

    /// Removes what is allowed; says of what is denied that it is.
    pub fn apply(&self, diagnostics: &mut Vec<Diagnostic>) {
        diagnostics.retain(|one| one.severity == Severity::Error || !self.allowed.contains(&one.code));
        for one in diagnostics.iter_mut().filter(|one| self.denies(one)) {
            one.notes.push("this warning is denied".to_owned());
        }
    }

    /// Whether a diagnostic is a warning that is denied.
    #[must_use]
    pub fn denies(&self, diagnostic: &Diagnostic) -> bool {
        diagnostic.severity == Severity::Warning && self.denies_code(diagnostic.code)
    }
}

/// The code of a warning.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Warning(Code);

impl Warning {
    /// All of them, in order.
    pub fn all() -> impl Iterator<Item = Warning> {
        let of_plants = [
            Code::CaseOnly,
            Code::Misreadable,
            Code::Unnoticed,
            Code::NeverEnabled,
            Code::Race,
            Code::ConflictUnknown,
            Code::Circle,
            Code::NeverGiven,
        ];
        let is_warning =
            move |code: Code| matches!(code as u16, 90..=99 | 130..=132) || of_plants.contains(&code);
        Code::ALL.iter().copied().filter(move |&code| is_warning(code)).map(Warning)
    }

    /// Whether the text alone shows it. Those of plants are found in any case.
    fn is_of_text(self) -> bool {
        let of_plants = self.0 as u16 >= 120;
        of_plants || matches!(self.0, Code::SystemOnlyWait | Code::Unused | Code::NeverCaused)
    }
}

impl FromStr for Warning {
    type Err = String;

    /// `SML0097`, as `sml explain` takes it: `97` is enough, case does not matter.
    fn from_str(text: &str) -> Result<Self, String> {
        Warning::all().find(|warning| Code::from_text(text) == Some(warning.0)).ok_or_else(|| {
            let codes: Vec<String> = Warning::all().map(|warning| warning.0.to_string()).collect();
            format!("there is no such warning; the warnings are {}", codes.join(", "))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::Span;

    fn warning(code: &str) -> Warning {
        code.parse().expect("a warning")
    }

    #[track_caller]
    fn check(policy: &Policy, shown: &[u16], denied: &[u16]) {
        let codes = [Code::Trapped, Code::Unused, Code::NeverCaused];
        let mut diagnostics: Vec<Diagnostic> =
            codes.map(|code| Diagnostic::warning(code, Span::default(), "")).into();
        diagnostics.push(Diagnostic::error(Code::Unrealizable, Span::default(), ""));
        policy.apply(&mut diagnostics);
        let numbers = |keep: &dyn Fn(&&Diagnostic) -> bool| -> Vec<u16> {
            diagnostics.iter().filter(keep).map(|one| one.code as u16).collect()
        };
        assert_eq!(numbers(&|_| true), shown);
        assert_eq!(numbers(&|one| policy.denies(one)), denied);
        assert_eq!(numbers(&|one| !one.notes.is_empty()), denied);
    }

    #[test]
    fn policies() {
        let none = Policy::default();
        check(&none, &[92, 97, 98, 70], &[]);
        check(&none.clone().deny(warning("SML0097")), &[92, 97, 98, 70], &[97]);
        check(&none.clone().allow(warning("sml0097")), &[92, 98, 70], &[]);
        check(&none.clone().deny_all(), &[92, 97, 98, 70], &[92, 97, 98]);
        check(&none.deny_all().allow(warning("SML0092")), &[97, 98, 70], &[97, 98]);
    }

    #[test]
    fn what_a_policy_has_to_see() {
        assert!(!Policy::default().deny(warning("SML0097")).denies_plays());
        assert!(!Policy::default().deny(warning("SML0131")).denies_plays());
        assert!(Policy::default().deny(warning("SML0092")).denies_plays());
        assert!(Policy::default().deny_all().denies_plays());
    }

    #[test]
    fn only_warnings() {
        assert_eq!(Warning::all().count(), 21);
        assert_eq!(warning("97"), warning("sml0097"));
        for wrong in ["SML0070", "SML0100", "9", ""] {
            let error = wrong.parse::<Warning>().expect_err("no warning");
            assert!(
                error.ends_with("SML0138, SML0139, SML0144, SML0145, SML0147, SML0148, SML0149"),
                "{error}"
            );
        }
    }
}
