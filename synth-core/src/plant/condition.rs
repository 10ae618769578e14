//! Boolean conditions as an engineer writes them.

/// A condition over atoms: signals in the formula of a state, states of automata in a constraint.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Condition<A> {
    /// An atom.
    Atom(A),
    /// `!`
    Not(Box<Condition<A>>),
    /// `&&` of two or more.
    And(Vec<Condition<A>>),
    /// `||` of two or more.
    Or(Vec<Condition<A>>),
}

impl<A> Condition<A> {
    /// Its value where `holds` says what an atom is.
    pub fn eval(&self, holds: &impl Fn(&A) -> bool) -> bool {
        match self {
            Condition::Atom(atom) => holds(atom),
            Condition::Not(inner) => !inner.eval(holds),
            Condition::And(all) => all.iter().all(|part| part.eval(holds)),
            Condition::Or(any) => any.iter().any(|part| part.eval(holds)),
        }
    }

    /// Its value where `holds` knows the value of some atoms: `None` if others decide.
    pub fn known(&self, holds: &impl Fn(&A) -> Option<bool>) -> Option<bool> {
        // `decisive` is the value of a part that decides for the whole.
        let joined = |parts: &[Condition<A>], decisive: bool| {
            let mut known = Some(!decisive);
            for part in parts {
                match part.known(holds) {
                    Some(value) if value == decisive => return Some(decisive),
                    Some(_) => {}
                    None => known = None,
                }
            }
            known
        };
        match self {
            Condition::Atom(atom) => holds(atom),
            Condition::Not(inner) => inner.known(holds).map(|value| !value),
            Condition::And(all) => joined(all, false),
            Condition::Or(any) => joined(any, true),
        }
    }

    /// What is left of it where `holds` knows the values of some atoms: a value, or a condition over all others.
    pub(super) fn rest(&self, holds: &impl Fn(&A) -> Option<bool>) -> Result<Condition<A>, bool>
    where
        A: Clone,
    {
        // `decisive` is the value of a part that decides for the whole.
        let rests = |parts: &[Condition<A>], decisive: bool| {
            let mut rests = Vec::with_capacity(parts.len());
            for part in parts {
                match part.rest(holds) {
                    Err(value) if value == decisive => return Err(decisive),
                    Err(_) => {}
                    Ok(rest) => rests.push(rest),
                }
            }
            if rests.is_empty() { Err(!decisive) } else { Ok(rests) }
        };
        Ok(match self {
            Condition::Atom(atom) => match holds(atom) {
                Some(value) => return Err(value),
                None => self.clone(),
            },
            Condition::Not(inner) => Condition::Not(Box::new(inner.rest(holds).map_err(|value| !value)?)),
            Condition::And(all) => Condition::And(rests(all, false)?),
            Condition::Or(any) => Condition::Or(rests(any, true)?),
        })
    }

    /// Calls `visit` for every atom, in textual order.
    pub fn atoms(&self, visit: &mut impl FnMut(&A)) {
        match self {
            Condition::Atom(atom) => visit(atom),
            Condition::Not(inner) => inner.atoms(visit),
            Condition::And(parts) | Condition::Or(parts) => parts.iter().for_each(|part| part.atoms(visit)),
        }
    }

    /// The same over what `resolve` makes of each atom, which is called for all of them in textual order; `None` if it
    /// makes nothing of one.
    pub fn resolved<'a, B>(&'a self, resolve: &mut impl FnMut(&'a A) -> Option<B>) -> Option<Condition<B>> {
        let mut all = |parts: &'a [Condition<A>]| {
            let parts: Vec<_> = parts.iter().map(|part| part.resolved(resolve)).collect();
            parts.into_iter().collect::<Option<Vec<_>>>()
        };
        Some(match self {
            Condition::And(parts) => Condition::And(all(parts)?),
            Condition::Or(parts) => Condition::Or(all(parts)?),
            Condition::Atom(atom) => Condition::Atom(resolve(atom)?),
            Condition::Not(inner) => Condition::Not(Box::new(inner.resolved(resolve)?)),
        })
    }

    /// As it is written, with only the parentheses that it needs; `name` is the text of an atom.
    pub fn text(&self, name: &impl Fn(&A) -> String) -> String {
        let part = |part: &Condition<A>, loose: bool| match part {
            Condition::Or(_) => format!("({})", part.text(name)),
            Condition::And(_) if !loose => format!("({})", part.text(name)),
            _ => part.text(name),
        };
        let joined = |parts: &[Condition<A>], loose, operator| {
            let parts: Vec<String> = parts.iter().map(|one| part(one, loose)).collect();
            parts.join(operator)
        };
        match self {
            Condition::Atom(atom) => name(atom),
            Condition::Not(inner) => format!("!{}", part(inner, false)),
            Condition::And(parts) => joined(parts, false, " && "),
            Condition::Or(parts) => joined(parts, true, " || "),
        }
    }
}
