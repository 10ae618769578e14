//! States and copies in words.

use super::{Copy, CopyId, EventId, Playout, ValuationId};
use crate::model::{Scenario, Spec, Type, UNSET, Value};

/// `Collaboration.Scenario[role=object,…]`, with the roles that are bound, by their names.
pub(crate) fn bound_name(spec: &Spec, scenario: &Scenario, roles: &[Value]) -> String {
    let bound = scenario.roles.iter().zip(roles).filter(|(_, value)| **value != UNSET);
    let mut bound: Vec<String> = bound
        .map(|(role, &value)| format!("{}={}", role.name, spec.domain.show(value, Type::Class(role.class))))
        .collect();
    bound.sort_unstable();
    if bound.is_empty() { scenario.name.clone() } else { format!("{}[{}]", scenario.name, bound.join(",")) }
}

impl Playout<'_> {
    /// The text of an event; that of none is `yield`.
    #[must_use]
    pub fn text(&self, event: Option<EventId>) -> &str {
        event.map_or("yield", |event| &self.event(event).text)
    }

    /// Copies in the order of the text: by scenario, binding, variables and cut, whatever was played before.
    #[must_use]
    pub fn in_text_order(&self, copies: &[CopyId]) -> Vec<CopyId> {
        let mut copies = copies.to_vec();
        copies.sort_by(|&a, &b| {
            let key = |copy| {
                let Copy { scenario, roles, variables, cut, .. } = self.copies.get(copy);
                (scenario, roles, variables, cut)
            };
            key(a).cmp(&key(b))
        });
        copies
    }

    /// `Collaboration.Scenario[role=object,…]`.
    #[must_use]
    pub fn copy_name(&self, copy: CopyId) -> String {
        let copy = self.copies.get(copy);
        bound_name(self.spec, &self.spec.scenarios[copy.scenario], &copy.roles)
    }

    /// The names and values of the variables of a copy that are set.
    #[must_use]
    pub fn variables(&self, copy: CopyId) -> Vec<(&str, String)> {
        let copy = self.copies.get(copy);
        let declared = self.spec.scenarios[copy.scenario].variables.iter().zip(&copy.variables);
        let set = declared.filter(|(_, value)| **value != UNSET);
        set.map(|(variable, &value)| (&*variable.name, self.spec.domain.show(value, variable.ty))).collect()
    }

    /// `object.attribute` and value of every attribute, by slot.
    #[must_use]
    pub fn attributes(&self, valuation: ValuationId) -> Vec<(String, String)> {
        let domain = &self.spec.domain;
        let values = self.valuations.get(valuation);
        let of_object = |object: &crate::model::Object| {
            let attributes = domain.classes[object.class].attributes.iter().enumerate();
            let shown = attributes.map(|(position, attribute)| {
                let value = values[object.first_slot + position];
                (format!("{}.{}", object.name, attribute.name), domain.show(value, attribute.ty))
            });
            shown.collect::<Vec<_>>()
        };
        domain.objects.iter().flat_map(of_object).collect()
    }
}
