//! Supervisors of single constraints, for people and for programs.

use super::supervise::formulas;
use serde_json::json;
use synth_core::diagnostic::counted;
use synth_core::plant::pipeline::ModularlySupervised;
use synth_core::plant::{Module, Plant, Realization, write_json};

fn realization(plant: &Plant, supervised: &ModularlySupervised) -> Option<Realization> {
    supervised.feedback.as_ref().map(|feedback| Realization::new(plant, feedback))
}

/// The names of its components.
fn components(module: &Module) -> Vec<&str> {
    let Plant { automata, components, .. } = &module.part.plant;
    automata[..*components].iter().map(|automaton| automaton.name.as_str()).collect()
}

/// A line a module, then formulas.
pub(super) fn text(plant: &Plant, supervised: &ModularlySupervised) -> String {
    let modules = &supervised.modular.modules;
    let verdict = match (&supervised.modular.unknown, modules.len()) {
        (_, 1) => "",
        (None, _) => ", which do not conflict",
        (Some(_), _) => "; whether they conflict is not known",
    };
    let mut rows = vec![["constraints", "components", "explored", "entries"].map(str::to_owned)];
    rows.extend(modules.iter().map(|module| {
        let constraints = module.constraints();
        [
            if constraints.is_empty() { "-".to_owned() } else { constraints.join(" ") },
            components(module).join(" "),
            module.closed.constrained.0.to_string(),
            module.closed.len().to_string(),
        ]
    }));
    let widths = [0, 1, 2, 3].map(|column| rows.iter().map(|row| row[column].len()).max().unwrap_or(0));
    let mut text = format!("{}{verdict}\n\n", counted(modules.len(), "module"));
    for [constraints, components, explored, entries] in rows {
        let [first, second, third, fourth] = widths;
        text.push_str(&format!(
            "{constraints:<first$}  {components:<second$}  {explored:>third$}  {entries:>fourth$}\n"
        ));
    }
    text.push('\n');
    text + &formulas(plant, supervised.feedback.as_ref())
}

/// The same as `sml supervise` writes of a whole plant, once for every module; then formulas and figures of the program.
pub(super) fn json(plant: &Plant, supervised: &ModularlySupervised) -> String {
    let modules = supervised.modular.modules.iter().map(|module| {
        let mut own = Vec::new();
        write_json(&module.part.plant, &module.closed, None, &mut own).expect("memory takes all");
        let own = String::from_utf8(own).expect("JSON is text");
        let (constraints, components) = (json!(module.constraints()), json!(components(module)));
        format!(
            "{{\"constraints\":{constraints},\"components\":{components},\"supervisor\":{}}}",
            own.trim_end()
        )
    });
    let modules: Vec<String> = modules.collect();
    let realization = realization(plant, supervised);
    let formulas = realization.iter().flat_map(|one| &one.formulas);
    let formulas: Vec<String> =
        formulas.map(|(event, text)| format!("{}:{}", json!(event), json!(text))).collect();
    let figures = realization.as_ref().map(|one| one.figures);
    format!(
        "{{\"version\":1,\"conflict_free\":{},\"modules\":[\n{}\n],\n\"formulas\":{{{}}},\"instructions\":{},\
         \"stack_depth\":{},\"rungs\":{}}}\n",
        if supervised.modular.unknown.is_none() { "true" } else { "null" },
        modules.join(",\n"),
        formulas.join(","),
        json!(figures.map(|figures| figures.instructions)),
        json!(figures.map(|figures| figures.stack_depth)),
        json!(figures.map(|figures| figures.rungs)),
    )
}
