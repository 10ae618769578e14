//! What becomes of interned things where objects change places. A permutation must map the specification onto itself.

use super::copies::{Identity, variables_read};
use super::events::Signature;
use super::{Config, CopyId, EventId, Key, KeyId, Playout, ValuationId};
use crate::model::{NodeId, Permutation, Scenario, Type, Value};

impl Playout<'_> {
    /// The state in which every object is in the place of another.
    pub(crate) fn permuted(&mut self, config: &Config, permutation: &Permutation) -> Config {
        let valuation = self.permuted_valuation(config.valuation, permutation);
        let mut copies: Vec<CopyId> =
            config.copies.iter().map(|&copy| self.permuted_copy(copy, permutation)).collect();
        copies.sort_unstable();
        Config { valuation, copies, yielded: config.yielded }
    }

    fn permuted_valuation(&mut self, valuation: ValuationId, permutation: &Permutation) -> ValuationId {
        let domain = &self.spec.domain;
        let before = self.valuations.get(valuation);
        let mut after = before.to_vec();
        for (object, &image) in domain.objects.iter().zip(&permutation.objects) {
            for (attribute, declared) in domain.classes[object.class].attributes.iter().enumerate() {
                let value = before[object.first_slot + attribute];
                after[domain.slot(image, attribute)] = permutation.value(value, declared.ty);
            }
        }
        self.valuations.intern(&after)
    }

    /// What a copy becomes.
    pub(crate) fn permuted_copy(&mut self, copy: CopyId, permutation: &Permutation) -> CopyId {
        let copy = self.copies.get(copy);
        let scenario = &self.spec.scenarios[copy.scenario];
        let types = scenario.variables.iter().map(|variable| variable.ty);
        let variables = copy.variables.iter().zip(types).map(|(&value, ty)| permutation.value(value, ty));
        let identity = Identity {
            scenario: permutation.scenarios[copy.scenario],
            roles: permuted_roles(&copy.roles, scenario, permutation),
            variables: variables.collect(),
            cut: copy.cut.clone(),
        };
        self.copies.intern(self.spec, &mut self.keys, identity)
    }

    /// What a key becomes.
    pub(crate) fn permuted_key(&mut self, key: KeyId, permutation: &Permutation) -> KeyId {
        let Key { scenario, roles, node, values } = self.keys.get(key);
        let declared = &self.spec.scenarios[*scenario];
        let image = Key {
            scenario: permutation.scenarios[*scenario],
            roles: permuted_roles(roles, declared, permutation),
            node: *node,
            values: permuted_values(values, declared, *node, permutation),
        };
        self.keys.intern(image).0
    }

    /// What an event becomes.
    pub(crate) fn permuted_event(&mut self, event: EventId, permutation: &Permutation) -> EventId {
        let event = self.events.get(event);
        let parameters = &self.spec.domain.operations[event.operation].parameters;
        let arguments = event.arguments.iter().zip(parameters);
        let signature = Signature {
            sender: permutation.objects[event.sender],
            receiver: permutation.objects[event.receiver],
            operation: event.operation,
            arguments: arguments.map(|(&value, (_, ty))| permutation.value(value, *ty)).collect(),
        };
        self.events.intern(self.spec, signature)
    }
}

fn permuted_roles(roles: &[Value], scenario: &Scenario, permutation: &Permutation) -> Box<[Value]> {
    let declared = roles.iter().zip(&scenario.roles);
    declared.map(|(&value, role)| permutation.value(value, Type::Class(role.class))).collect()
}

/// Of the variables that a fragment reads.
fn permuted_values(
    values: &[Value],
    scenario: &Scenario,
    node: NodeId,
    permutation: &Permutation,
) -> Box<[Value]> {
    let variables = variables_read(scenario, node);
    let typed = values.iter().zip(variables);
    typed.map(|(&value, variable)| permutation.value(value, scenario.variables[variable].ty)).collect()
}
