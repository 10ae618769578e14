//! What is measured: members of the families of `tests/src/families`.

use std::fmt;

/// A family with the members that are measured.
#[derive(PartialEq, Eq, Debug)]
pub(super) struct Family {
    /// What the example `family` calls it.
    pub(super) name: &'static str,
    /// For people.
    pub(super) title: &'static str,
    /// Whether it is also measured on one thread.
    pub(super) on_one_thread: bool,
    /// Members, ascending, with their states: of the game, or of the plant under its feedback.
    pub(super) members: &'static [(u32, u64)],
}

/// Plants are supervised, specifications are synthesised.
const PLANTS: [&str; 2] = ["transfer-line", "philosophers"];

impl Family {
    pub(super) fn is_of_plants(&self) -> bool {
        PLANTS.contains(&self.name)
    }
}

/// All that are measured.
pub(super) static FAMILIES: [Family; 6] = [
    Family {
        name: "line",
        title: "production line",
        on_one_thread: true,
        members: &[(1, 218), (2, 3_216), (3, 45_792), (4, 635_904), (5, 8_667_648)],
    },
    Family {
        name: "lift",
        title: "lift",
        on_one_thread: false,
        members: &[
            (3, 68),
            (4, 192),
            (5, 496),
            (6, 1_216),
            (7, 2_880),
            (8, 6_656),
            (10, 33_792),
            (12, 163_840),
            (15, 1_654_784),
        ],
    },
    Family {
        name: "two-lifts",
        title: "two lifts",
        on_one_thread: false,
        members: &[(2, 84), (3, 500), (4, 2_016), (5, 6_768), (6, 20_416), (8, 153_600)],
    },
    Family {
        name: "arbiter",
        title: "arbiter",
        on_one_thread: false,
        members: &[
            (3, 27),
            (4, 63),
            (5, 143),
            (6, 319),
            (7, 703),
            (8, 1_535),
            (10, 7_167),
            (12, 32_767),
            (15, 311_295),
            (17, 1_376_255),
        ],
    },
    Family {
        name: "transfer-line",
        title: "transfer line",
        on_one_thread: false,
        members: &[(3, 50), (4, 250), (5, 1_250), (6, 6_250), (7, 31_250), (8, 156_250)],
    },
    Family {
        name: "philosophers",
        title: "philosophers",
        on_one_thread: false,
        members: &[(3, 13), (4, 33), (5, 81), (6, 197), (8, 1_153), (10, 6_725), (12, 39_201), (14, 228_485)],
    },
];

/// One member of a family.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Member {
    /// Place in [`FAMILIES`].
    pub(super) family: usize,
    pub(super) number: u32,
}

impl Member {
    pub(super) fn family(self) -> &'static Family {
        &FAMILIES[self.family]
    }

    /// The member that is called so.
    pub(super) fn called(family: &str, number: &str) -> Option<Member> {
        let number: u32 = number.parse().ok()?;
        all().find(|member| member.family().name == family && member.number == number)
    }

    /// States, as they are known beforehand.
    pub(super) fn states(self) -> u64 {
        let members = self.family().members;
        members.iter().find(|(number, _)| *number == self.number).map_or(0, |(_, states)| *states)
    }

    /// The command that prints it.
    pub(super) fn command(self) -> [String; 2] {
        [self.family().name.to_owned(), self.number.to_string()]
    }

    /// Its file.
    pub(super) fn file(self) -> String {
        let kind = if self.family().is_of_plants() { "plant" } else { "sml" };
        format!("{}-{}.{kind}", self.family().name, self.number)
    }
}

impl fmt::Display for Member {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.family().name, self.number)
    }
}

/// All members, by families.
pub(super) fn all() -> impl Iterator<Item = Member> {
    FAMILIES.iter().enumerate().flat_map(|(family, Family { members, .. })| {
        members.iter().map(move |&(number, _)| Member { family, number })
    })
}
