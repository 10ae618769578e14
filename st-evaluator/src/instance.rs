//! What runs.

use std::time::Duration;

use crate::code::Place;
use crate::declare::{Section, Variable};
use crate::error::{AccessError, RuntimeError};
use crate::kind::Kind;
use crate::machine::{Machine, Stats};
use crate::types::{Type, TypeId};
use crate::unit::Unit;
use crate::value::Value;

/// Statements and iterations of a call, unless [`Instance::set_limit`] says otherwise.
const DEFAULT_LIMIT: u64 = 100_000_000;

/// A function block, program, function or configuration with its variables.
///
/// Names are paths, in which case does not count: `state`, `pending[3]`, `timer.ET`, `grid[1, 2]`. All variables can
/// be read, those that the text hides as well.
#[derive(Clone, Debug)]
pub struct Instance<'u> {
    unit: &'u Unit,
    machine: Machine,
    /// With the addresses of their cells.
    roots: Vec<(Root, usize)>,
    stack: usize,
    limit: u64,
}

/// A part of a configuration, or the only one, whose name is empty.
#[derive(Clone, Debug)]
pub(crate) struct Root {
    pub(crate) name: String,
    pub(crate) pou: usize,
}

/// Where a variable of an instance is: found once, it is read and written without looking for its name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Slot {
    ty: TypeId,
    address: usize,
    constant: bool,
}

impl<'u> Instance<'u> {
    pub(crate) fn new(unit: &'u Unit, roots: Vec<Root>) -> Instance<'u> {
        let mut memory = unit.constants.clone();
        let globals = memory.len();
        memory.extend_from_slice(&unit.global_cells);
        let mut placed = Vec::new();
        for root in roots {
            let pou = &unit.pous[root.pou];
            let image = if unit.is_function(root.pou) { &pou.frame } else { &pou.image };
            placed.push((root, memory.len()));
            memory.extend_from_slice(image);
        }
        let stack = memory.len();
        let machine = Machine::new(memory, globals);
        Instance { unit, machine, roots: placed, stack, limit: DEFAULT_LIMIT }
    }

    /// Runs it once, with the inputs as they are.
    ///
    /// # Errors
    ///
    /// What stops the run. The variables stay as they were then.
    pub fn call(&mut self) -> Result<Stats, RuntimeError> {
        self.machine.begin(self.stack, self.limit);
        for (root, address) in &self.roots {
            let done = if self.unit.is_function(root.pou) {
                let pou = &self.unit.pous[root.pou];
                for variable in pou.scope.variables.iter().filter(|v| v.section != Section::Input) {
                    if let Place::Frame(at) = variable.place {
                        let range = at as usize..at as usize + self.unit.types.size(variable.ty) as usize;
                        let to = address + range.start;
                        self.machine.memory[to..to + range.len()].copy_from_slice(&pou.frame[range]);
                    }
                }
                self.machine.run_function(&self.unit.pous, root.pou, *address)
            } else {
                self.machine.run_block(&self.unit.pous, root.pou, *address)
            };
            done.map_err(|fault| *fault)?;
        }
        Ok(self.machine.stats)
    }

    /// Lets time pass for the timers.
    pub fn advance(&mut self, duration: Duration) {
        let nanoseconds = i64::try_from(duration.as_nanos()).unwrap_or(i64::MAX);
        self.machine.clock = self.machine.clock.saturating_add(nanoseconds);
    }

    /// Allows a call so many statements and iterations; one that takes more is taken for endless.
    pub fn set_limit(&mut self, statements: u64) {
        self.limit = statements;
    }

    /// Writes a variable.
    ///
    /// # Errors
    ///
    /// There is no such variable, it is constant, or it does not take the value.
    pub fn set(&mut self, path: &str, value: impl Into<Value>) -> Result<(), AccessError> {
        let slot = self.slot(path)?;
        self.set_at(slot, value).map_err(|AccessError(message)| AccessError(format!("`{path}`: {message}")))
    }

    /// Reads a variable.
    ///
    /// # Errors
    ///
    /// There is no such variable.
    pub fn get(&self, path: &str) -> Result<Value, AccessError> {
        self.slot(path).map(|slot| self.get_at(slot))
    }

    /// Writes a variable of this instance.
    ///
    /// # Errors
    ///
    /// It is constant, or does not take the value.
    pub fn set_at(&mut self, slot: Slot, value: impl Into<Value>) -> Result<(), AccessError> {
        if slot.constant {
            return Err(AccessError("it is constant".to_owned()));
        }
        self.write(slot.ty, slot.address, &value.into()).map_err(AccessError)
    }

    /// Reads a variable of this instance.
    #[must_use]
    pub fn get_at(&self, slot: Slot) -> Value {
        self.read(slot.ty, slot.address)
    }

    /// Reads a `BOOL`.
    ///
    /// # Errors
    ///
    /// There is no such variable, or it is none.
    pub fn bool(&self, path: &str) -> Result<bool, AccessError> {
        self.get(path)?.as_bool().ok_or_else(|| AccessError(format!("`{path}` is no `BOOL`")))
    }

    /// Reads an integer, bit string or enumeration.
    ///
    /// # Errors
    ///
    /// There is no such variable, or it is none.
    pub fn int(&self, path: &str) -> Result<i128, AccessError> {
        self.get(path)?.as_int().ok_or_else(|| AccessError(format!("`{path}` is no integer")))
    }

    /// Reads an array of `BOOL`.
    ///
    /// # Errors
    ///
    /// There is no such variable, or it is none.
    pub fn bools(&self, path: &str) -> Result<Vec<bool>, AccessError> {
        let value = self.get(path)?;
        let elements =
            value.as_array().map(|values| values.iter().map(Value::as_bool).collect::<Option<_>>());
        elements.flatten().ok_or_else(|| AccessError(format!("`{path}` is no array of `BOOL`")))
    }

    /// The paths and values of all variables that a power cycle leaves as they are, those of blocks inside of blocks
    /// included: [`Instance::set`] in a new instance is a warm start.
    #[must_use]
    pub fn retained(&self) -> Vec<(String, Value)> {
        let mut retained = Vec::new();
        for (root, address) in &self.roots {
            let prefix = if root.name.is_empty() { String::new() } else { format!("{}.", root.name) };
            self.collect_retained(root.pou, *address, &prefix, false, &mut retained);
        }
        retained
    }

    /// Inside of a block that is retained itself, everything is.
    fn collect_retained(
        &self,
        pou: usize,
        base: usize,
        prefix: &str,
        whole: bool,
        retained: &mut Vec<(String, Value)>,
    ) {
        let variables = self.unit.pous[pou].scope.variables.iter();
        for variable in variables.filter(|variable| matches!(variable.place, Place::This(_))) {
            let path = format!("{prefix}{}", variable.name);
            let address = base + variable.offset() as usize;
            let kept = whole || variable.retain;
            match self.unit.types.get(variable.ty) {
                Type::Block { pou, .. } => {
                    self.collect_retained(*pou, address, &format!("{path}."), kept, retained);
                }
                _ if kept => retained.push((path, self.read(variable.ty, address))),
                _ => {}
            }
        }
    }

    /// Where a variable is.
    ///
    /// # Errors
    ///
    /// There is no such variable.
    pub fn slot(&self, path: &str) -> Result<Slot, AccessError> {
        let unknown = |what: &str| AccessError(format!("`{path}`: there is no `{what}`"));
        let end = |text: &str| text.find(['.', '[']).unwrap_or(text.len());
        let (mut name, mut rest) = path.split_at(end(path));
        let mut base = None;
        for (root, address) in &self.roots {
            if root.name.is_empty() {
                base = Some((root, *address));
            } else if root.name.eq_ignore_ascii_case(name) {
                base = Some((root, *address));
                let inner = rest.strip_prefix('.').ok_or_else(|| unknown(path))?;
                (name, rest) = inner.split_at(end(inner));
                break;
            }
        }
        let capitals = name.trim().to_ascii_uppercase();
        let own = base.and_then(|(root, address)| {
            let variable = self.unit.pous[root.pou].scope.get(&capitals)?;
            // The frame of a call is gone, and references are not variables.
            let kept = match variable.section {
                Section::External | Section::InOut => false,
                Section::Temp => self.unit.is_function(root.pou),
                _ => true,
            };
            kept.then_some((variable, address))
        });
        let global = || self.unit.globals.get(&capitals).map(|variable| (variable, 0));
        let (variable, address) = own.or_else(global).ok_or_else(|| unknown(name))?;
        let mut found = self.variable(variable, address);
        while !rest.is_empty() {
            if let Some(inner) = rest.strip_prefix('.') {
                let (name, next) = inner.split_at(end(inner));
                found = self.member(found, name.trim()).ok_or_else(|| unknown(name))?;
                rest = next;
            } else {
                let close = rest.find(']').ok_or_else(|| unknown(rest))?;
                found = self.element(found, &rest[1..close]).ok_or_else(|| unknown(&rest[..=close]))?;
                rest = &rest[close + 1..];
            }
        }
        Ok(found)
    }

    fn variable(&self, variable: &Variable, base: usize) -> Slot {
        let address = match variable.place {
            Place::Constant(at) => at as usize,
            Place::Global(at) => self.machine.globals() + at as usize,
            _ => base + variable.offset() as usize,
        };
        Slot { ty: variable.ty, address, constant: variable.constant }
    }

    fn member(&self, of: Slot, name: &str) -> Option<Slot> {
        match self.unit.types.get(of.ty) {
            Type::Structure { fields, .. } => {
                let field = fields.iter().find(|field| field.name.eq_ignore_ascii_case(name))?;
                let address = of.address + field.offset as usize;
                Some(Slot { ty: field.ty, address, constant: of.constant })
            }
            Type::Block { pou, .. } => {
                let variable = self.unit.pous[*pou].scope.get(&name.to_ascii_uppercase())?;
                Some(self.variable(variable, of.address))
            }
            _ => None,
        }
    }

    fn element(&self, of: Slot, indices: &str) -> Option<Slot> {
        let Type::Array { limits, element, .. } = self.unit.types.get(of.ty) else { return None };
        let indices: Vec<i64> = indices.split(',').map(|i| i.trim().parse().ok()).collect::<Option<_>>()?;
        if indices.len() != limits.len() {
            return None;
        }
        let mut row: i64 = 0;
        for (index, (low, high)) in indices.iter().zip(limits) {
            if index < low || index > high {
                return None;
            }
            row = row * (high - low + 1) + (index - low);
        }
        let address = of.address + row as usize * self.unit.types.size(*element) as usize;
        Some(Slot { ty: *element, address, constant: of.constant })
    }

    fn read(&self, ty: TypeId, address: usize) -> Value {
        let types = &self.unit.types;
        let cell = self.machine.memory.get(address).copied().unwrap_or_default();
        match types.get(ty) {
            Type::Elementary(Kind::Bool) => Value::Bool(cell != 0),
            Type::Elementary(Kind::Time) => Value::Time(cell),
            Type::Elementary(kind) | Type::Subrange { base: kind, .. } => Value::Int(kind.value(cell)),
            Type::Enumeration { .. } | Type::Pointer(_) => Value::Int(cell.into()),
            Type::Text { .. } => {
                let bytes =
                    self.machine.memory[address + 1..=address + cell as usize].iter().map(|&c| c as u8);
                Value::Text(bytes.map(char::from).collect())
            }
            Type::Array { element, .. } => {
                let size = types.size(*element) as usize;
                let count = types.size(ty) as usize / size.max(1);
                Value::Array((0..count).map(|index| self.read(*element, address + index * size)).collect())
            }
            Type::Structure { fields, .. } => {
                let field =
                    |f: &crate::types::Field| (f.name.clone(), self.read(f.ty, address + f.offset as usize));
                Value::Structure(fields.iter().map(field).collect())
            }
            Type::Block { pou, .. } => {
                let variables = self.unit.pous[*pou].scope.variables.iter();
                let kept = variables.filter(|v| matches!(v.place, Place::This(_)));
                let value = |v: &Variable| (v.name.clone(), self.read(v.ty, address + v.offset() as usize));
                Value::Structure(kept.map(value).collect())
            }
        }
    }

    fn write(&mut self, ty: TypeId, address: usize, value: &Value) -> Result<(), String> {
        let unit = self.unit;
        let cell = match (unit.types.get(ty), value) {
            (Type::Elementary(Kind::Bool), Value::Bool(value)) => i64::from(*value),
            (Type::Elementary(Kind::Time), Value::Time(value)) => *value,
            (Type::Elementary(kind), Value::Int(value)) if *kind != Kind::Bool && *kind != Kind::Time => {
                let (low, high) = kind.range();
                if *value < low || *value > high {
                    return Err(format!("{value} is not within `{}`", kind.name()));
                }
                *value as i64
            }
            (Type::Subrange { low, high, .. }, Value::Int(value)) => {
                if *value < i128::from(*low) || *value > i128::from(*high) {
                    return Err(format!("{value} is not within {low}..{high}"));
                }
                *value as i64
            }
            (Type::Enumeration { values, .. }, Value::Int(value)) => {
                let known = values.iter().map(|(_, v)| *v).find(|v| i128::from(*v) == *value);
                known.ok_or_else(|| format!("there is no value {value}"))?
            }
            (Type::Text { capacity }, Value::Text(text)) => {
                if text.len() > *capacity as usize || !text.is_ascii() {
                    return Err(format!("only {capacity} ASCII characters fit"));
                }
                let cells = &mut self.machine.memory[address + 1..address + *capacity as usize + 2];
                cells.fill(0);
                for (cell, byte) in cells.iter_mut().zip(text.bytes()) {
                    *cell = i64::from(byte);
                }
                text.len() as i64
            }
            (Type::Array { element, .. }, Value::Array(values)) => {
                let size = unit.types.size(*element) as usize;
                if values.len() * size != unit.types.size(ty) as usize {
                    return Err(format!("{} elements do not fit", values.len()));
                }
                for (index, value) in values.iter().enumerate() {
                    self.write(*element, address + index * size, value)?;
                }
                return Ok(());
            }
            _ => return Err(format!("{value:?} is no `{}`", unit.types.name(ty))),
        };
        self.machine.memory[address] = cell;
        Ok(())
    }
}
