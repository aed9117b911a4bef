import * as Comlink from 'comlink';
import { ModelRenderer } from './model_renderer';

Comlink.expose(ModelRenderer);
