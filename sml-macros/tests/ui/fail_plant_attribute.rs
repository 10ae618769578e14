//! Attributes that plants do not have.

sml_macros::plant! { #![dont_care = "some"] "specs/clamp.plant" }
sml_macros::plant! { #![dont_care] "specs/clamp.plant" }
sml_macros::plant! { #![extract] #![engine = "runs"] "specs/clamp.plant" }
sml_macros::plant! { #![extract] #![extract] "specs/clamp.plant" }

fn main() {}
