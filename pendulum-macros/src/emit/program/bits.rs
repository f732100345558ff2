//! Operations on the bits of numbers.

use super::Writer;
use crate::parse::Float;
use crate::program::Id;
use crate::program::interpret::HEAD_MASK;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

impl Writer<'_> {
    pub(super) fn head(&self, x: Id) -> TokenStream {
        let x = self.atom(x);
        let mask = format!("{HEAD_MASK:#x}").parse::<Literal>().unwrap_or_else(|_| Literal::u64_unsuffixed(HEAD_MASK));
        quote!(f64::from_bits(#x.to_bits() & #mask))
    }

    pub(super) fn alternate(&self, x: Id, magic: Id, bit: u32) -> TokenStream {
        let [float, type_of_magic] = [x, magic].map(|id| self.program.nodes[id].float);
        let (cast, sign) = match (float, type_of_magic) {
            (Float::F64, _) => (quote!(), 63u32),
            (Float::F32, Float::F32) => (quote!(), 31),
            (Float::F32, Float::F64) => (quote!(as u32), 31),
        };
        let (x, magic) = (self.atom(x), self.atom(magic));
        let shift = Literal::u32_unsuffixed(sign - bit);
        let bits = if cast.is_empty() { quote!(#magic.to_bits()) } else { quote!((#magic.to_bits() #cast)) };
        // The lowest bit shifts all others out.
        if bit == 0 {
            return quote!(#float::from_bits(#x.to_bits() ^ (#bits << #shift)));
        }
        let mask = sign_bit(float);
        quote!(#float::from_bits(#x.to_bits() ^ (#bits << #shift & #mask)))
    }

    pub(super) fn copy_sign(&self, magnitude: Id, sign: Id) -> TokenStream {
        let (magnitude, sign) = (self.atom(magnitude), self.value(sign));
        quote!(#magnitude.copysign(#sign))
    }

    pub(super) fn along(&self, x: Id, sign: Id) -> TokenStream {
        let sign = self.atom(sign);
        self.flipped(x, &quote!(#sign.to_bits()))
    }

    pub(super) fn against(&self, x: Id, sign: Id) -> TokenStream {
        let sign = self.atom(sign);
        self.flipped(x, &quote!(!#sign.to_bits()))
    }

    /// x with its sign flipped where the first of these bits is set.
    fn flipped(&self, x: Id, bits: &TokenStream) -> TokenStream {
        let float = self.program.nodes[x].float;
        let (x, mask) = (self.atom(x), sign_bit(float));
        quote!(#float::from_bits(#x.to_bits() ^ (#bits & #mask)))
    }

    pub(super) fn power_of_two(&self, magic: Id) -> TokenStream {
        let magic = self.atom(magic);
        quote!(f64::from_bits(#magic.to_bits().wrapping_add(1023) << 52))
    }

    pub(super) fn row(&self, magic: Id) -> TokenStream {
        let magic = self.atom(magic);
        let mask = Literal::usize_unsuffixed(self.program.table.len() - 1);
        quote!(&TABLE[(#magic.to_bits() & #mask) as usize])
    }
}

/// In hexadecimal.
fn sign_bit(float: Float) -> Literal {
    let mask = if float == Float::F64 { "0x8000_0000_0000_0000" } else { "0x8000_0000" };
    mask.parse::<Literal>().unwrap_or_else(|_| Literal::u64_unsuffixed(1 << 63))
}
