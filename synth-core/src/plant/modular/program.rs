//! One program of all modules.
//!
//! Every module has a program of its own, checked against its feedback. They are put together rung by rung: an event fires
//! where all modules that know it would let it fire, and then the bits of memory of all of them change. What concludes from
//! what is seen stands in front, module by module; no two modules share a bit.

use super::super::formulas::{Formula, FormulaError};
use super::super::state_feedback::unique;
use super::super::{Coil, Drive, EventId, Options, Plant, Program, Rung, StateFeedback, Use, Variable};
use super::Modular;
use super::scope::place;
use crate::logic::{Bdd, Expr, Literal, TooLarge, Var, count, factor, instructions, minimize, run};

/// Conditions of several modules are made one function and minimised anew up to so many variables; beyond, they are put in
/// series as they are.
const FEW_VARIABLES: usize = 16;

/// Puts the programs of modules together; they must have been made without extraction and without relays for what conditions
/// have in common. Of the options, `two_level` says which formulas are taken, `extract` is done here.
///
/// # Errors
/// A condition is too large, or its instructions failed their check.
pub(in super::super) fn program(
    plant: &Plant,
    modular: &Modular,
    own: &[StateFeedback],
    options: Options,
) -> Result<StateFeedback, FormulaError> {
    let mut all = Assembly::new(plant, modular, own, options);
    for (module, feedback) in own.iter().enumerate() {
        let updates = all.views[module].updates;
        for rung in &feedback.program.rungs[..updates] {
            let rung = all.renamed(module, rung);
            all.program.rungs.push(rung);
        }
    }
    let knowing = knowing(plant, modular);
    let controllable = (0..).zip(&plant.events).filter(|(_, event)| event.controllable);
    let mut formulas = Vec::new();
    for (event, _) in controllable {
        formulas.push(all.event(event, &knowing[event as usize])?);
    }
    Ok(StateFeedback { formulas, program: all.program })
}

/// Per event the modules that know it.
fn knowing(plant: &Plant, modular: &Modular) -> Vec<Vec<usize>> {
    let mut knowing = vec![Vec::new(); plant.events.len()];
    for (module, one) in modular.modules.iter().enumerate() {
        one.part.events.iter().for_each(|&event| knowing[event as usize].push(module));
    }
    knowing
}

/// Where the rungs of an event are in the program of a module.
#[derive(Clone, Debug)]
struct Block {
    event: EventId,
    /// Relays that are found before the event fires.
    first: usize,
    /// Its rung.
    own: usize,
    /// The end of what is driven by those relays.
    end: usize,
}

/// The program of a module, as it is taken apart.
struct View {
    /// What the whole program calls its variables.
    variables: Vec<Var>,
    /// So many rungs at the beginning are not an event's.
    updates: usize,
    blocks: Vec<Block>,
}

impl View {
    fn new(program: &Program, variables: Vec<Var>) -> Self {
        let rungs = &program.rungs;
        let writes = |rung: &Rung| rung.coils.iter().any(|coil| coil.drive == Drive::Out);
        let mut blocks = Vec::new();
        for (own, rung) in rungs.iter().enumerate() {
            let Some(event) = rung.event else { continue };
            let behind = rungs[own + 1..].iter().take_while(|rung| rung.event.is_none() && !writes(rung));
            let relays: Vec<Var> = behind.clone().filter_map(|rung| relay(&rung.condition)).collect();
            let before = rungs[..own].iter().rev().take_while(|rung| {
                rung.event.is_none() && rung.coils.iter().any(|coil| relays.contains(&coil.variable))
            });
            blocks.push(Block { event, first: own - before.count(), own, end: own + 1 + behind.count() });
        }
        let updates = blocks.first().map_or(rungs.len(), |block| block.first);
        View { variables, updates, blocks }
    }

    fn block(&self, event: EventId) -> Option<&Block> {
        self.blocks.iter().find(|block| block.event == event)
    }
}

/// The only contact of a condition, if it is one.
fn relay(condition: &Expr) -> Option<Var> {
    match condition {
        Expr::Literal(Literal { variable, negated: false }) => Some(*variable),
        _ => None,
    }
}

struct Assembly<'a> {
    plant: &'a Plant,
    modular: &'a Modular,
    own: &'a [StateFeedback],
    options: Options,
    views: Vec<View>,
    program: Program,
    /// The relay that says that an event has fired in this scan.
    fired: Option<Var>,
}

impl<'a> Assembly<'a> {
    fn new(plant: &'a Plant, modular: &'a Modular, own: &'a [StateFeedback], options: Options) -> Self {
        let mut whole = Program::without_rungs(plant);
        let variables = &mut whole.variables;
        let mut views = Vec::with_capacity(own.len());
        for (module, StateFeedback { program, .. }) in modular.modules.iter().zip(own) {
            let signals = &module.part.signals;
            let mut names = signals.clone();
            for (variable, &signal) in program.variables.iter().zip(signals) {
                if variable.usage == Use::Memory(true) {
                    variables[signal as usize].usage = Use::Memory(true);
                }
            }
            for variable in &program.variables[signals.len()..] {
                names.push(variables.len() as Var);
                let name = unique(variables, &variable.name);
                variables.push(Variable { name, ..variable.clone() });
            }
            views.push(View::new(program, names));
        }
        Assembly { plant, modular, own, options, views, program: whole, fired: None }
    }

    fn variable(&self, module: usize, variable: Var) -> Var {
        self.views[module].variables[variable as usize]
    }

    fn renamed(&self, module: usize, rung: &Rung) -> Rung {
        let coil = |coil: &Coil| Coil { variable: self.variable(module, coil.variable), ..*coil };
        Rung {
            event: None,
            comment: rung.comment.clone(),
            condition: rung.condition.renamed(&|variable| self.variable(module, variable)),
            coils: rung.coils.iter().map(coil).collect(),
        }
    }

    /// The rungs of an event.
    fn event(&mut self, event: EventId, modules: &[usize]) -> Result<Formula, FormulaError> {
        let Plant { events, .. } = self.plant;
        let declared = &events[event as usize];
        let too_large = |reason| FormulaError::TooLarge { event: Some(event), reason };
        let formulas: Vec<Formula> =
            modules.iter().filter_map(|&module| self.formula(module, event)).collect();
        let formula = conjunction(event, &formulas, self.options.two_level).map_err(too_large)?;
        let formula = formula.ok_or(FormulaError::Wrong { event: Some(event) })?;
        let condition = match &formula.terms {
            Ok(terms) if self.options.two_level => terms.cover.expr(),
            Err(reason) if self.options.two_level => return Err(too_large(*reason)),
            _ => formula.factored.clone(),
        };
        if condition == Expr::Constant(false) {
            self.program.doc.push(format!("`{}` never fires: no entry enables it", declared.name));
            return Ok(formula);
        }
        let blocks: Vec<(usize, Block)> = modules
            .iter()
            .filter_map(|&module| {
                let local = place(&self.modular.modules[module].part.events, event)?;
                Some((module, self.views[module].block(local)?.clone()))
            })
            .collect();
        if blocks.is_empty() {
            self.program.doc.push(format!("`{}` has no rung: it commands nothing", declared.name));
            return Ok(formula);
        }
        self.blocks(event, &blocks, &condition, formulas.len() > 1);
        Ok(formula)
    }

    fn blocks(&mut self, event: EventId, blocks: &[(usize, Block)], condition: &Expr, several: bool) {
        let own = self.own;
        let guard = self.fired.filter(|_| self.options.extract).map(|fired| Expr::literal(fired, false));
        let guarded = |expr: Expr| Expr::all(guard.iter().cloned().chain([expr]).collect());
        for (module, block) in blocks {
            for rung in &own[*module].program.rungs[block.first..block.own] {
                let mut rung = self.renamed(*module, rung);
                // What one module alone would do is done only if all let the event fire.
                if several {
                    rung.condition = Expr::all(vec![condition.clone(), rung.condition]);
                }
                rung.condition = guarded(rung.condition);
                self.program.rungs.push(rung);
            }
        }
        let mut coils: Vec<Coil> = Vec::new();
        let mut comment = Vec::new();
        for (module, block) in blocks {
            let rung = self.renamed(*module, &own[*module].program.rungs[block.own]);
            coils.extend(rung.coils.into_iter().filter(|coil| !coils.contains(coil)).collect::<Vec<_>>());
            let name = self.modular.modules[*module].constraints().join(", ");
            let named = several && !name.is_empty();
            comment.extend(
                rung.comment.into_iter().map(|line| if named { format!("{name}: {line}") } else { line }),
            );
        }
        if self.options.extract {
            let drive = if self.fired.is_some() { Drive::Set } else { Drive::Out };
            let variable = self.interlock();
            coils.push(Coil { variable, drive });
        }
        let condition = match guarded(condition.clone()) {
            // A rung cannot do without a contact.
            Expr::Constant(_) => Expr::Or(vec![Expr::literal(0, true), Expr::literal(0, false)]),
            condition => condition,
        };
        self.program.rungs.push(Rung { event: Some(event), comment, condition, coils });
        for (module, block) in blocks {
            for rung in &own[*module].program.rungs[block.own + 1..block.end] {
                let rung = self.renamed(*module, rung);
                self.program.rungs.push(rung);
            }
        }
    }

    fn interlock(&mut self) -> Var {
        *self.fired.get_or_insert_with(|| {
            let name = unique(&self.program.variables, "fired");
            self.program.variables.push(Variable { name, usage: Use::Scratch, doc: Vec::new() });
            self.program.variables.len() as Var - 1
        })
    }

    /// The formula that a module has for an event, in the variables of the whole.
    fn formula(&self, module: usize, event: EventId) -> Option<Formula> {
        let local = place(&self.modular.modules[module].part.events, event)?;
        let formula = self.own[module].formulas.iter().find(|formula| formula.event == local)?;
        let variable = |variable: Var| self.variable(module, variable);
        Some(Formula {
            event,
            terms: formula
                .terms
                .clone()
                .map(|terms| crate::logic::Minimal { cover: terms.cover.renamed(variable), ..terms }),
            factored: formula.factored.renamed(&variable).in_order(),
        })
    }
}

/// Where all formulas hold; `None` if its instructions fail their check. Without any, it holds nowhere: no component names
/// the event.
fn conjunction(event: EventId, formulas: &[Formula], two_level: bool) -> Result<Option<Formula>, TooLarge> {
    let (first, others) = match formulas {
        [] => {
            let mut bdd = Bdd::new();
            let terms = minimize(&mut bdd, false.into(), false.into());
            return Ok(Some(Formula { event, terms, factored: Expr::Constant(false) }));
        }
        [first, others @ ..] => (first, others),
    };
    if others.iter().all(|other| other == first) {
        return Ok(Some(first.clone()));
    }
    let series = Expr::all(formulas.iter().map(|formula| formula.factored.clone()).collect());
    let mut variables = Vec::new();
    support(&series, &mut variables);
    variables.sort_unstable();
    variables.dedup();
    let rank = |variable: Var| variables.partition_point(|&other| other < variable) as Var;
    let name = |rank: Var| variables[rank as usize];
    let mut bdd = Bdd::new();
    let function = series.renamed(&rank).function(&mut bdd)?;
    let few = variables.len() <= FEW_VARIABLES;
    let terms = if few || two_level {
        minimize(&mut bdd, function, function)
    } else {
        Err(TooLarge::Variables(variables.len()))
    };
    let mut factored = series.renamed(&rank);
    if few {
        let other = factor(&mut bdd, function, function, &[])?;
        if count(&other) < count(&factored) {
            factored = other;
        }
    }
    // The instructions, run on all values at once.
    let mut values: Vec<_> =
        (0..variables.len() as Var).map(|rank| bdd.variable(rank)).collect::<Result<_, _>>()?;
    let found = match &factored {
        Expr::Constant(value) => Some((*value).into()),
        _ => run(&mut bdd, &instructions(&factored), &mut values)?,
    };
    Ok((found == Some(function)).then(|| Formula {
        event,
        terms: terms.map(|terms| crate::logic::Minimal { cover: terms.cover.renamed(name), ..terms }),
        factored: factored.renamed(&name).in_order(),
    }))
}

fn support(expr: &Expr, variables: &mut Vec<Var>) {
    match expr {
        Expr::Constant(_) => {}
        Expr::Literal(literal) => variables.push(literal.variable),
        Expr::And(parts) | Expr::Or(parts) => parts.iter().for_each(|part| support(part, variables)),
    }
}
