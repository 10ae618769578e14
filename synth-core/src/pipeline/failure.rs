//! Why a stage gave no result, and what to tell the author.

use super::Figures;
use crate::diagnostic::{Code, Diagnostic, counted};
use crate::explain::Explanation;
use crate::explore::{ExploreError, LimitReached};
use crate::plant::Unavoidable;
use crate::syntax::Span;
use crate::verify::{Refutation, VerifyError};

/// Why there is no result.
#[derive(Debug)]
pub enum Failure {
    /// The specification is wrong.
    Wrong(Vec<Diagnostic>),
    /// No controller can meet it.
    Unrealizable(Box<Unrealizable>),
    /// No feedback keeps the constraints of a plant.
    Refused(Box<Refused>),
    /// A limit was reached.
    Limit(LimitReached),
    /// The controller did not pass verification. This is a mistake of this project, never of the specification.
    Unverified(Refutation),
    /// The solver contradicts itself. This is a mistake of this project, never of the specification.
    Inconsistent(String),
}

impl Failure {
    /// What to tell the author of the specification, the earliest mistake first.
    #[must_use]
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        let general = |code, message: String| Diagnostic::error(code, Span::default(), message);
        let ours = "this is a mistake of the tool, not of what it was given; nothing was written";
        match self {
            Failure::Wrong(diagnostics) => diagnostics.clone(),
            Failure::Unrealizable(unrealizable) => vec![unrealizable.diagnostic.clone()],
            Failure::Refused(refused) => vec![refused.diagnostic.clone()],
            Failure::Limit(limit) => vec![
                general(
                    Code::LimitReached,
                    format!("the limit of {} was reached", counted(limit.limit, limit.unit())),
                )
                .note(limit.to_string())
                .help(match limit.what {
                    // No option goes beyond what ids can count.
                    "edges" => "make what is described smaller".to_owned(),
                    what => format!("raise `--max-{what}`, or make what is described smaller"),
                }),
            ],
            Failure::Unverified(refutation) => vec![
                general(Code::VerificationFailed, format!("verification failed: {}", refutation.reason))
                    .note(format!("the play: {}", refutation.play.join("; ")))
                    .note(ours),
            ],
            Failure::Inconsistent(why) => {
                vec![
                    general(Code::VerificationFailed, format!("the solver contradicts itself: {why}"))
                        .note(ours),
                ]
            }
        }
    }
}

impl From<ExploreError> for Failure {
    fn from(error: ExploreError) -> Self {
        match error {
            ExploreError::Play(mistake, play) => Failure::Wrong(vec![mistake.diagnostic(&play)]),
            ExploreError::Limit(limit) => Failure::Limit(limit),
        }
    }
}

impl From<VerifyError> for Failure {
    fn from(error: VerifyError) -> Self {
        match error {
            VerifyError::Refuted(refutation) => Failure::Unverified(refutation),
            VerifyError::Play(mistake, play) => Failure::Wrong(vec![mistake.diagnostic(&play)]),
            // Nodes of the product are bounded by the same number as states.
            VerifyError::TooLarge(nodes) => Failure::Limit(LimitReached {
                what: "states",
                limit: nodes,
                states: nodes,
                explored: nodes,
                edges: 0,
                memory: 0,
            }),
        }
    }
}

/// What is known of a specification that no controller can meet.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unrealizable {
    /// The size of the game.
    pub figures: Figures,
    /// Why, as a message.
    pub diagnostic: Diagnostic,
    /// Why, as data.
    pub explanation: Explanation,
}

/// What is known of a plant whose constraints no feedback keeps.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Refused {
    /// Why, as a message.
    pub diagnostic: Diagnostic,
    /// Why, as data.
    pub unavoidable: Unavoidable,
}
